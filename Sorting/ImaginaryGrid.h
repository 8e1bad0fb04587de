/**
 * Puts imaginary cells into a grid, after the cells of the mesh.
 */
#ifndef ImaginaryGrid_h
#define ImaginaryGrid_h

class vtkUnstructuredGrid;
struct ImaginaryCells;

namespace ImaginaryGrid
{
/** Whether the grid has cells that its array `Imaginary` marks. */
bool HasImaginaryCells(vtkUnstructuredGrid* grid);

/** `output` becomes `input` and the cells, with the arrays `Imaginary` and `ImaginaryContacts`. */
void Append(vtkUnstructuredGrid* input, const ImaginaryCells& cells, vtkUnstructuredGrid* output);
}

#endif
