#ifndef RayOrder_h
#define RayOrder_h

#include "BoxTree.h"
#include "RayCells.h"
#include "vtkType.h"

#include <array>
#include <random>
#include <vector>

class vtkUnstructuredGrid;
struct ShearedRay;

/// Checks orders of cells along random rays, gaps and cavities included. Shares no code with the
/// sorts. Coincident points are one; a face is the fan of triangles from its smallest point id.
class RayOrder
{
public:
  struct Result
  {
    int Rays = 0;
    /// Rays on which any two cells come out in the wrong order.
    int WrongRays = 0;
    /// Neighbours along a ray, and those in the wrong order.
    long long Pairs = 0;
    long long WrongPairs = 0;
    /// Pairs of cells whose segments overlap: no order of theirs is right, and nothing on a ray
    /// that meets one is judged.
    long long OverlappingPairs = 0;
    int OverlappingRays = 0;
    /// Rays that are wrong but for cells that run through each other: on other rays their segments
    /// overlap, and no order of theirs is right.
    int CrossingRays = 0;
    /// Rays that would be wrong were the pairs within groups not let off.
    int RaysLetOff = 0;
    /// The first two cells found wrong: `Near` is in front, and does not come after `Far`.
    vtkIdType Near = -1;
    vtkIdType Far = -1;
    /// Of that ray.
    std::array<double, 3> Direction{ { 0.0, 0.0, 0.0 } };
  };

  /// Cells of dimension 3. Cells with a true `skipped` are left out.
  explicit RayOrder(vtkUnstructuredGrid* grid, const std::vector<bool>& skipped = {});

  /// `eye`: a point, or with eye[3] = 0 a direction towards the eye. `order`: back to front; cells
  /// that it does not name are wrong wherever a ray meets them. `groups`: per cell the group within
  /// which nothing is compared, or -1; may be empty.
  Result Check(const double eye[4], const std::vector<vtkIdType>& order,
    const std::vector<int>& groups = {}, int rays = 2000) const;

private:
  using Point = std::array<double, 3>;
  struct Segment
  {
    double Begin, End;
    vtkIdType Cell;
  };
  struct Rays;
  struct Scratch;

  Point RandomPointIn(int cell, unsigned int seed) const;
  void AddSegments(const ShearedRay& ray, int cell, bool fromEye, Scratch& scratch,
    std::vector<Segment>& segments) const;
  Rays RaysFrom(const double eye[4], int count, std::mt19937& random) const;
  std::vector<std::vector<Segment>> SegmentsOf(const Rays& rays, bool fromEye) const;
  /// Whether an edge of one cell runs through a triangle of the other, beyond rounding.
  bool DoCross(vtkIdType a, vtkIdType b) const;
  bool HasEdgeThrough(vtkIdType a, vtkIdType b) const;
  int CountOverlaps(const std::vector<Segment>& segments) const;
  static bool IsFarFirst(
    const std::vector<Segment>& segments, const std::vector<vtkIdType>& rank);
  void Compare(const std::vector<Segment>& segments, const std::vector<vtkIdType>& rank,
    const std::vector<int>& groups, Result& result) const;

  vtkIdType NumberOfCells;
  RayCells Cells;
  BoxTree Tree;
};

#endif
