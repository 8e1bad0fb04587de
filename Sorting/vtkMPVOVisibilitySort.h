/**
 * @class   vtkMPVOVisibilitySort
 * @brief   the visibility order of any mesh, with a proof
 *
 * Papers: Williams, Visibility Ordering Meshed Polyhedra, 1992 (MPVO); Kraus and Ertl,
 * Cell-Projection of Cyclic Meshes, 2001 (MPVO-C); Roettger et al., Convexification of Unstructured
 * Grids, 2004.
 *
 * Every shared face says which of its two cells is the nearer one, by the exact side of its plane
 * on which the eye lies; a topological sort follows these relations, cell by cell. With Convexify
 * (the default) what the mesh leaves out of its convex hull is filled first, once per mesh, so that
 * cells which a gap, a hole or a cavity separates are related too. A face that is not planar counts
 * as its triangles.
 *
 * Cells that hide each other in a circle have no order: GetCyclicGroups() names them, each group
 * contiguous in the order with its farthest centre first; a mapper can resolve them per pixel.
 *
 * With Convexify off the order follows the shared faces alone. In the far half of the mesh cells with
 * nothing behind them come from the farthest centre on; the near half is sorted from its end, cells
 * with nothing before them from the nearest centre on (in the spirit of Williams' MPVO-NC). It is
 * right for convex meshes, often for others, and not proven: an eye amid the cells of a mesh with gaps
 * may get parts of it the wrong way round.
 *
 * Any linear 3-D cells, mixed. Cells of other kinds are returned too, in no particular place. The
 * order is computed again only where the eye has crossed the plane of a face, or the mesh has
 * changed. Up to 2^29 cells.
 */

#ifndef vtkMPVOVisibilitySort_h
#define vtkMPVOVisibilitySort_h

#include "vtkProvenVisibilitySort.h"

class VTKCELLPROJECTION_EXPORT vtkMPVOVisibilitySort : public vtkProvenVisibilitySort
{
public:
  static vtkMPVOVisibilitySort* New();
  vtkTypeMacro(vtkMPVOVisibilitySort, vtkProvenVisibilitySort);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How often an order was computed: a traversal that reuses the last one does not count.
   */
  vtkGetMacro(NumberOfSorts, vtkIdType);

protected:
  vtkMPVOVisibilitySort();
  ~vtkMPVOVisibilitySort() override;

  const std::vector<vtkIdType>& SortCells(const double eye[4]) override;
  void FindCyclicGroups(std::vector<vtkIdType>& cells, std::vector<vtkIdType>& offsets) override;
  bool IsOrderRightAcrossGaps() override;

private:
  vtkMPVOVisibilitySort(const vtkMPVOVisibilitySort&) = delete;
  void operator=(const vtkMPVOVisibilitySort&) = delete;

  vtkIdType NumberOfSorts = 0;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
