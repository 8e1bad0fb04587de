#ifndef ReportErrors_h
#define ReportErrors_h

class vtkCellProjectionOracle;

/// What one method gets wrong in several images: of the pixels together the root mean square and
/// the share, of the images the largest maximum and percentile.
class ReportErrors
{
public:
  /// `compared` has just been compared with the method's image; `isInside`: the eye is in the mesh.
  void Add(vtkCellProjectionOracle* compared, bool isInside);

  double GetRootMeanSquare() const;
  double GetRootMeanSquareOutside() const;
  double GetPercentile() const { return this->Percentile; }
  double GetMaximum() const { return this->Maximum; }
  /// Below zero: no view was from inside.
  double GetMaximumInside() const { return this->MaximumInside; }
  double GetShare() const;

private:
  struct Sum
  {
    double Squares = 0.0;
    double AboveHalfLevel = 0.0;
    double Pixels = 0.0;
  };
  Sum All, Outside;
  double Percentile = 0.0;
  double Maximum = 0.0;
  double MaximumInside = -1.0;
};

#endif
