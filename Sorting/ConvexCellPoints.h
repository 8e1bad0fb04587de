/**
 * The points of one run of vtkConvexCells: which go by which id, those added to the mesh, and how
 * they are numbered in the output.
 *
 * An id is that of an input point, or from the number of input points on that of an added one.
 */
#ifndef ConvexCellPoints_h
#define ConvexCellPoints_h

#include "ConvexCellPlan.h"
#include "PointCoordinates.h"

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <vector>

class vtkIdList;
class vtkPoints;
class vtkPointSet;
class vtkUnstructuredGrid;

class ConvexCellPoints
{
public:
  using Coordinates = std::array<double, 3>;

  /** What an added point's data are made of. */
  struct Origin
  {
    vtkIdType Cell;
    /** Where in the curved cell it lies; of no use in other cells. */
    Coordinates Reference;
  };
  /** Gives the input points, and one weight for each, whose data make those of a point. */
  using Interpolation =
    std::function<void(const Origin& origin, vtkIdList* ids, std::vector<double>& weights)>;

  explicit ConvexCellPoints(vtkPointSet* input);
  ~ConvexCellPoints();

  void Merge();
  /** By input point: the id that it goes by, or a negative number. */
  const std::vector<vtkIdType>& GetCanonical() const { return this->Canonical; }
  /** Whole where all points can be drawn. */
  static ConvexCellPlan::FateType FateOf(const vtkIdType* ids, vtkIdType count);

  /** As precise as the output will be. */
  Coordinates Round(const Coordinates& x) const;
  /** The id of a new point. Not from several threads at once. */
  vtkIdType Add(const Coordinates& x, const Origin& origin);
  vtkIdType GetNumberOfAddedPoints() const { return static_cast<vtkIdType>(this->Added.size()); }
  vtkIdType GetNumberOfIds() const { return this->NumberOfPoints + this->GetNumberOfAddedPoints(); }
  void Get(vtkIdType id, double x[3]) const;
  void Get(const vtkIdType* ids, int count, double (*x)[3]) const;

  /** After the last point was added. */
  void NumberOutput();
  /** By id; null where the output has the points of the input, as they are. */
  const vtkIdType* GetOutputIds() const
  {
    return this->OutputIds.empty() ? nullptr : this->OutputIds.data();
  }
  vtkIdType GetNumberOfMergedPoints() const { return this->NumberOfMergedPoints; }

  /** Points and their data. */
  void Fill(vtkPointSet* input, vtkUnstructuredGrid* output, const Interpolation& interpolate);
  /** Gives back what Fill does not need. */
  void ReleaseWorkingMemory();

private:
  void MakeOutputPoints(vtkPointSet* input);

  const unsigned char* Ghosts;
  const vtkIdType NumberOfPoints;
  const int DataType;
  const PointCoordinates Source;
  std::vector<vtkIdType> Canonical;
  std::vector<Coordinates> Added;
  std::vector<Origin> Origins;
  std::vector<vtkIdType> OutputIds;
  std::vector<vtkIdType> SourcePoints; // by output point, before the added ones; empty likewise
  vtkIdType NumberOfMergedPoints = 0;
  vtkSmartPointer<vtkPoints> OutputPoints; // null where the input's are taken
};

#endif
