/**
 * Puts imaginary cells into a grid, after the cells of the mesh.
 */
#ifndef ImaginaryGrid_h
#define ImaginaryGrid_h

#include "vtkType.h"

class vtkDataSet;
class vtkUnstructuredGrid;
struct CellComplex;
struct ImaginaryCells;

namespace ImaginaryGrid
{
/** Whether the grid has cells that its array `Imaginary` marks. */
bool HasImaginaryCells(vtkDataSet* grid);

/** Takes what `Append` put into a grid out of the grid's complex, and into `cells`. False, and
 *  nothing is changed, where there is nothing, or it does not fit. */
bool Take(vtkDataSet* grid, CellComplex& complex, ImaginaryCells& cells);

/** `output` becomes `input` and the cells, with the arrays `Imaginary` and `ImaginaryContacts`.
 *  The cells are VTK_POLYHEDRON, or VTK_TETRA where they are said to be tetrahedra. */
void Append(vtkUnstructuredGrid* input, const ImaginaryCells& cells, vtkUnstructuredGrid* output);

struct Size
{
  vtkIdType Faces = 0;
  double Volume = 0.0;
};

/** Of the cells from `begin` to before `end`, each convex. */
Size Measure(vtkUnstructuredGrid* grid, vtkIdType begin, vtkIdType end);
}

#endif
