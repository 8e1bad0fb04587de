/**
 * @class   vtkBSPXMPVOVisibilitySort
 * @brief   visibility order of meshes that are not convex, by a BSP tree of their boundary
 *
 * Paper: Comba, Klosowski, Max, Mitchell, Silva, Williams, Fast Polyhedral Cell Sorting for
 * Interactive Rendering of Unstructured Grids, 1999. The baseline that convexification is measured
 * against, and a second opinion in tests. Never convexifies.
 *
 * Not guaranteed: what it does with cells that hide each other in a circle; GetNumberOfCycles() is
 * 0 always, IsOrderProven() false.
 */

#ifndef vtkBSPXMPVOVisibilitySort_h
#define vtkBSPXMPVOVisibilitySort_h

#include "vtkProvenVisibilitySort.h"
#include "vtkTimeStamp.h"

#include <memory> // for std::unique_ptr

class BoundaryRelations;

class vtkBSPXMPVOVisibilitySort : public vtkProvenVisibilitySort
{
public:
  static vtkBSPXMPVOVisibilitySort* New();
  vtkTypeMacro(vtkBSPXMPVOVisibilitySort, vtkProvenVisibilitySort);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Of the last traversal: cells that a circle left over, relations added for partially projected
   * cells, fragments of the boundary in the tree.
   */
  int GetNumberOfLeftCells() const;
  int GetNumberOfAddedRelations() const;
  int GetNumberOfFragments() const;
  ///@}

protected:
  vtkBSPXMPVOVisibilitySort();
  ~vtkBSPXMPVOVisibilitySort() override;

  const std::vector<vtkIdType>& SortCells(const double eye[4]) override;

private:
  vtkBSPXMPVOVisibilitySort(const vtkBSPXMPVOVisibilitySort&) = delete;
  void operator=(const vtkBSPXMPVOVisibilitySort&) = delete;

  std::unique_ptr<BoundaryRelations> Relations;
  std::vector<vtkIdType> Order;
  vtkTimeStamp BuildTime;
};

#endif
