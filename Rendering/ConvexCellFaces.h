#ifndef ConvexCellFaces_h
#define ConvexCellFaces_h

#include <vector>

class vtkUnstructuredGrid;

/**
 * @class ConvexCellFaces
 * @brief The cells of a mesh as lists of corners and faces; a face that two cells share is one.
 *
 * Takes what vtkConvexCells gives: tetrahedra, pyramids, wedges, hexahedra, pentagonal and
 * hexagonal prisms and polyhedra. Other types have no faces.
 *
 * A face is a loop of point ids that begins with the smallest and goes on with the smaller one of
 * its neighbours, whichever cell it was read from.
 */
class ConvexCellFaces
{
public:
  /// Rows of different lengths: row i is Values[Offsets[i]] to Values[Offsets[i + 1]].
  struct Rows
  {
    std::vector<int> Offsets{ 0 };
    std::vector<int> Values;

    int GetNumberOfRows() const { return static_cast<int>(this->Offsets.size()) - 1; }
    int GetSize(int row) const { return this->Offsets[row + 1] - this->Offsets[row]; }
    const int* GetRow(int row) const { return this->Values.data() + this->Offsets[row]; }
    void Append(const std::vector<int>& row);
    void Append(const Rows& other);
  };

  void Build(vtkUnstructuredGrid* cells);

  int GetNumberOfCells() const { return this->Corners.GetNumberOfRows(); }
  int GetNumberOfFaces() const { return this->Loops.GetNumberOfRows(); }

  Rows Corners; ///< Point ids per cell.
  Rows Faces;   ///< Faces per cell.
  Rows Loops;   ///< Point ids per face.

private:
  void MergeLoops(const Rows& loops);
};

#endif
