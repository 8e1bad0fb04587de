#ifndef BackToFrontOrder_h
#define BackToFrontOrder_h

#include "VisibilitySortChoice.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"
#include "vtkVisibilitySort.h"

#include <array>
#include <string>
#include <vector>

class vtkCamera;
class vtkProvenVisibilitySort;
class vtkUnstructuredGrid;
struct CellProjectionFrame;

/**
 * @class BackToFrontOrder
 * @brief A mesh's cells in the order of a vtkVisibilitySort, kept until the view or the mesh
 * changes.
 *
 * The order is a permutation whatever the sort returns: ids it repeats or invents are left out, ids
 * it forgets come last; both are counted.
 *
 * A vtkProvenVisibilitySort also tells which cells hide each other in a circle: spans of the order.
 */
class BackToFrontOrder
{
public:
  /// `sort` null: the power sort where it is exact, else MPVO. True where the order was computed
  /// anew. New `cells` have new points and cells (as the output of vtkConvexCells has); scalars do
  /// not count.
  bool Update(vtkVisibilitySort* sort, vtkUnstructuredGrid* cells, CellProjectionFrame& frame);

  /// Positions Begin .. End - 1 of Cells.
  struct Span
  {
    vtkIdType Begin;
    vtkIdType End;
  };

  std::vector<vtkIdType> Cells;
  /// Ascending and disjoint.
  std::vector<Span> CyclicGroups;
  vtkIdType NumberOfWrongIds = 0;

  /// Shared faces whose cells come out in the wrong order, counted now; 0 where the sort cannot.
  vtkIdType CountMisorderedFaces();

private:
  /// What an order depends on, the sort itself and the mesh apart.
  using View = std::array<double, 33>;
  static View TakeView(CellProjectionFrame& frame);
  void Collect(vtkVisibilitySort* sort, vtkIdType numberOfCells);
  void FindCyclicGroups(vtkProvenVisibilitySort* sort);
  void KeepDisjoint(std::vector<Span>& spans);
  vtkVisibilitySort* Choose(vtkVisibilitySort* sort, vtkUnstructuredGrid* cells, vtkCamera* camera);

  VisibilitySortChoice Automatic;
  vtkVisibilitySort* SeenSort = nullptr;
  vtkMTimeType SeenSortTime = 0;
  vtkMTimeType SeenCells = 0;
  View SeenView{};
};

#endif
