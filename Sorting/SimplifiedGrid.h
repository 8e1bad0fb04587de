/**
 * A simplification's mesh as a grid, and the error of its field where it no longer reaches.
 */
#ifndef SimplifiedGrid_h
#define SimplifiedGrid_h

class TetrahedraSimplification;
class vtkDataArray;
class vtkUnstructuredGrid;

namespace SimplifiedGrid
{
/** `grid`: what was simplified; `scalars`: its array, whose place the simplification's takes, which
 * is returned. */
vtkDataArray* Fill(const TetrahedraSimplification& simplification, vtkUnstructuredGrid* grid,
  vtkDataArray* scalars, vtkUnstructuredGrid* output);

/** The largest error of samples outside of `grid`, which Fill has made, at its nearest places;
 *  `middle`: what the samples' places are relative to. */
double FindOutsideError(const TetrahedraSimplification& simplification, const double middle[3],
  vtkUnstructuredGrid* grid, vtkDataArray* scalars);
}

#endif
