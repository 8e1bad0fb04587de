/**
 * The cells of any unstructured grid, read by many threads at once: types, points by the ids that
 * they go by, faces of polyhedra; and which cells are refused before their shape is looked at.
 */
#ifndef ConvexCellReader_h
#define ConvexCellReader_h

#include "ConvexCellPlan.h"

#include "vtkSmartPointer.h"

#include <vector>

class ConvexCellPoints;
class PolyhedronSurface;
class vtkIdList;
class vtkUnstructuredGrid;
class vtkUnstructuredGridBase;

class ConvexCellReader
{
public:
  explicit ConvexCellReader(vtkUnstructuredGridBase* input);
  ~ConvexCellReader();

  /** Reads the types; grids that cannot be read by threads are copied. */
  void Open();
  /** Forgets the input, not its types. */
  void Close();

  /** VTK types by cell. */
  const std::vector<unsigned char>& GetTypes() const { return this->Types; }
  bool HasSameTypes(vtkUnstructuredGridBase* input) const;

  /** Ghost, Hidden, Imaginary, or Whole for a cell that is not refused. */
  ConvexCellPlan::FateType Refuse(vtkIdType cell) const;

  /** Of VTK's type, or of its linear twin. False for those that are no such shape. */
  static bool ShapeOf(int cellType, TetrahedralSplit::Shape& shape);

  /** Ids as `canonical` names them, in the order of the shape; the corners of a curved cell. False
   *  where the cell is not one of this mesh. `list` is scratch. */
  bool ReadIds(vtkIdType cell, TetrahedralSplit::Shape shape,
    const std::vector<vtkIdType>& canonical, vtkIdList* list, vtkIdType* ids) const;

  /** The same for all points of any cell. */
  bool ReadAllIds(vtkIdType cell, const std::vector<vtkIdType>& canonical, vtkIdList* list,
    std::vector<vtkIdType>& ids) const;

  /** The same for a polyhedron, or for the hull of a convex point set. Whole where it was read and
   *  its points can be drawn. */
  ConvexCellPlan::FateType ReadSurface(vtkIdType cell, const ConvexCellPoints& points,
    vtkIdList* list, PolyhedronSurface& surface) const;

  /** The mesh; a copy of it where the input cannot be read by threads. Null when closed, but for a copy. */
  vtkUnstructuredGrid* GetGrid() const { return this->Grid; }

private:
  void CopyCells();
  void ReadList(vtkIdType cell, vtkIdList* list, vtkIdType& size, const vtkIdType*& ids) const;
  ConvexCellPlan::FateType ListHull(
    vtkIdType cell, const ConvexCellPoints& points, vtkIdList* list) const;

  vtkUnstructuredGridBase* Input;
  const unsigned char* GhostCells;
  const unsigned char* ImaginaryCells;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::vector<unsigned char> Types;
};

#endif
