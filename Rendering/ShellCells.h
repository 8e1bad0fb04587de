#ifndef ShellCells_h
#define ShellCells_h

#include "vtkType.h"

#include <vector>

class TetrahedraSelection;
struct RasterView;

/**
 * @class ShellCells
 * @brief Between which distances from the eye each tetrahedron lies.
 *
 * Left out, with Nearest above Farthest: cells that are not drawn whatever the view, those outside
 * the view or behind a clipping plane, and those with a point that is not finite.
 */
class ShellCells
{
public:
  /// `points` 4 floats each, mesh coordinates; `corners` 4 ids per cell. Uses all threads.
  void Build(const std::vector<float>& points, const std::vector<int>& corners,
    const TetrahedraSelection& selection, const RasterView& view);

  bool IsSeen(vtkIdType cell) const { return this->Nearest[cell] <= this->Farthest[cell]; }
  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Nearest.size()); }

  /// World lengths, bounds from below and above.
  std::vector<float> Nearest;
  std::vector<float> Farthest;
  /// Over all cells that are seen; the second below the first where there is none.
  double Range[2] = { 0.0, -1.0 };
  vtkIdType NumberOfSeenCells = 0;
  vtkIdType NumberOfOutsideCells = 0;
  /// Points moved to where there are no numbers.
  vtkIdType NumberOfLostCells = 0;

private:
  struct Place;
  static std::vector<Place> FindPlaces(const std::vector<float>& points, const RasterView& view);
  void SetCell(vtkIdType cell, const int* corners, const std::vector<Place>& places,
    const RasterView& view);
  void Count(const TetrahedraSelection& selection);
};

#endif
