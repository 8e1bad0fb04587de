#ifndef BackToFrontOrder_h
#define BackToFrontOrder_h

#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"
#include "vtkVisibilitySort.h"

#include <array>
#include <string>
#include <vector>

class vtkUnstructuredGrid;
struct CellProjectionFrame;

/**
 * @class BackToFrontOrder
 * @brief A mesh's cells in the order of a vtkVisibilitySort, kept until the view or the mesh
 * changes.
 *
 * The order is a permutation whatever the sort returns: ids it repeats or invents are left out, ids
 * it forgets come last; both are counted.
 */
class BackToFrontOrder
{
public:
  /// `sort` null: VTK's sort by cell centres. True where the order was computed anew.
  bool Update(vtkVisibilitySort* sort, vtkUnstructuredGrid* cells, CellProjectionFrame& frame);

  std::vector<vtkIdType> Cells;
  vtkIdType NumberOfWrongIds = 0;

private:
  /// What an order depends on, the sort itself and the mesh apart.
  using View = std::array<double, 33>;
  static View TakeView(CellProjectionFrame& frame);
  void Collect(vtkVisibilitySort* sort, vtkIdType numberOfCells);
  vtkVisibilitySort* Choose(vtkVisibilitySort* sort);

  vtkSmartPointer<vtkVisibilitySort> Default;
  vtkVisibilitySort* SeenSort = nullptr;
  vtkMTimeType SeenSortTime = 0;
  vtkMTimeType SeenCells = 0;
  View SeenView{};
};

#endif
