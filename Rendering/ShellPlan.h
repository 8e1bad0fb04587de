#ifndef ShellPlan_h
#define ShellPlan_h

/**
 * @class ShellPlan
 * @brief Where the slices and shells of a view lie: slice k at k times Spacing from the eye, each
 * shell as thick as SamplesPerShell slices.
 */
class ShellPlan
{
public:
  /// More slices than this are refused: such a frame would not end.
  static constexpr double MaximumNumberOfSlices = 65536.0;

  /// `range`: distances between which there are cells. With `withEnds` a slice lies before the
  /// first cell and one behind the last.
  void Build(const double range[2], double spacing, int samplesPerShell, bool withEnds);

  /// How many slices cross the cells, before any is refused.
  static double CountSlices(const double range[2], double spacing);

  /// The first and the last shell in which cells between these distances can have a sample or an
  /// end.
  void FindShells(double nearest, double farthest, int shells[2]) const;

  /// Distance of a shell's first slice.
  double GetDistance(int shell) const;

  double Spacing = 1.0;
  int SamplesPerShell = 8;
  int NumberOfShells = 0;

private:
  double FirstSlice = 0.0;
  double Margin = 0.0;
};

#endif
