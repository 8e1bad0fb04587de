/**
 * @class   vtkPowerVisibilitySort
 * @brief   order by squared tangential distance: the fastest, and exact on Delaunay meshes
 *
 * A cell's key is the power of the eye with regard to the cell's circumsphere, its squared
 * tangential distance. In the form that is sorted here it is one dot product per cell and frame,
 * followed by a parallel radix sort; nothing depends on which cells touch, and no adjacency is
 * built unless a proof is asked for.
 *
 * Where every inner face is regular (a cell's sphere keeps clear of its neighbours' corners) the
 * order is right for every eye, in perspective and in parallel projection: Max, Hanrahan, Crawfis
 * 1990; Cignoni, De Floriani 1998; Karasick et al. 1997. `IsExact()` says so once and for all eyes.
 * Elsewhere the order is a good guess, and `GetNumberOfMisorderedFaces()` counts for each eye what
 * is wrong with it.
 *
 * Not guaranteed: an exact order where spheres tie. Lattices cut into tetrahedra are not Delaunay
 * (the tetrahedra of a cube share one sphere), lattices of boxes are. Cells whose corners lie on no
 * common sphere take the fit of least squares. Eyes within rounding of a face's plane may see its
 * two cells exchanged, which the count shows and no pixel does.
 *
 * Input, batches, eye and proof: see vtkProvenVisibilitySort. Imaginary cells take no part in the
 * order, so that it is proven for convex meshes alone.
 */

#ifndef vtkPowerVisibilitySort_h
#define vtkPowerVisibilitySort_h

#include "vtkCellProjectionModule.h" // for export macro
#include "vtkProvenVisibilitySort.h"

#include <memory> // for std::unique_ptr
#include <vector> // for std::vector

class VTKCELLPROJECTION_EXPORT vtkPowerVisibilitySort : public vtkProvenVisibilitySort
{
public:
  static vtkPowerVisibilitySort* New();
  vtkTypeMacro(vtkPowerVisibilitySort, vtkProvenVisibilitySort);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Faces between two cells across which the mesh is not Delaunay beyond rounding; 0 where the keys
   * order all neighbours for every eye. A face of more than three corners counts once per triangle.
   * Computed once per mesh, when first asked for; 0 without an input.
   */
  vtkIdType GetNumberOfIrregularFaces();

  /**
   * Whether the order is right for every eye, without a count: a convex mesh without overlaps,
   * and no irregular face. Computed once per mesh, when first asked for. False where Convexify is
   * off: it is what finds out whether the mesh is convex.
   */
  bool IsExact();

protected:
  vtkPowerVisibilitySort();
  ~vtkPowerVisibilitySort() override;

  const std::vector<vtkIdType>& SortCells(const double eye[4]) override;

private:
  vtkPowerVisibilitySort(const vtkPowerVisibilitySort&) = delete;
  void operator=(const vtkPowerVisibilitySort&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
