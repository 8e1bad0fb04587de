#ifndef GroupSort_h
#define GroupSort_h

#include "FaceOrderSort.h"
#include "vtkProvenVisibilitySort.h"
#include "vtkSmartPointer.h"

#include <vector>

/// Says that groups of cells hide each other in a circle, and shuffles each group: the mapper has
/// nothing to go by there but the pixels. By default all cells are one such group.
class GroupSort : public vtkProvenVisibilitySort
{
public:
  static GroupSort* New();
  vtkTypeMacro(GroupSort, vtkProvenVisibilitySort);

  /// Forgets the last order.
  void Modified() override;

  /// The order in which the groups follow each other; null: that of the cells' numbers.
  vtkSmartPointer<vtkVisibilitySort> Inner;
  /// Every other GroupSize cells of that order are a group; 0: all are one.
  vtkIdType GroupSize = 0;
  /// How often an order was asked for.
  int NumberOfSorts = 0;

protected:
  GroupSort() = default;
  ~GroupSort() override = default;
  const std::vector<vtkIdType>& SortCells(const double eye[4]) override;
  void FindCyclicGroups(std::vector<vtkIdType>& cells, std::vector<vtkIdType>& offsets) override;

private:
  void FindInnerOrder(std::vector<vtkIdType>& order);

  std::vector<vtkIdType> Order;
  std::vector<vtkIdType> GroupCells;
  std::vector<vtkIdType> GroupOffsets;
};

#endif
