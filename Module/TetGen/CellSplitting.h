/**
 * Any cells to conforming tetrahedra, each cell by itself: those of vtkConvexCells, and by TetGen
 * the polyhedra that it leaves out because no point sees all of them.
 */
#ifndef CellSplitting_h
#define CellSplitting_h

#include "TransferredData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class PolyhedronSurface;
class vtkIdList;
class vtkUnstructuredGrid;
struct ConcaveCell;

class CellSplitting
{
public:
  explicit CellSplitting(vtkUnstructuredGrid* input);
  ~CellSplitting();

  /** Writes the tetrahedra, with all data and `SourceCell`. */
  void Run(vtkUnstructuredGrid* output);

  /** Cells that TetGen cut. */
  vtkIdType NumberOfCutCells = 0;
  /** Cells that it could not cut, the first of them, and why it could not. */
  vtkIdType NumberOfFailedCells = 0;
  vtkIdType FirstFailedCell = -1;
  std::string FirstFailure;
  /** Cells without a tetrahedron, the failed ones included. */
  vtkIdType NumberOfSkippedCells = 0;
  /** Points that TetGen made. */
  vtkIdType NumberOfNewPoints = 0;

private:
  void SplitConvexCells();
  void NumberPoints();
  void TakeTetrahedra(TetrahedraOutput& tetrahedra) const;
  void CutLeftOut(TetrahedraOutput& tetrahedra);
  bool ReadSurface(vtkIdType cell, vtkIdList* stream, PolyhedronSurface& surface) const;
  void CutCell(vtkIdType cell, PolyhedronSurface& surface, TetrahedraOutput& tetrahedra);
  void AddCell(vtkIdType cell, const PolyhedronSurface& surface, const ConcaveCell& cut,
    TetrahedraOutput& tetrahedra) const;

  vtkUnstructuredGrid* Input;
  /** What vtkConvexCells makes of it. */
  vtkSmartPointer<vtkUnstructuredGrid> Split;
  /** By input point: its number there, that of the point it was merged with; -1 for none. */
  std::vector<vtkIdType> PointNumbers;
};

#endif
