/**
 * The cells that ConvexCellPlan and PolyhedronPlan write, their data, and where they come from.
 */
#ifndef ConvexCellGrid_h
#define ConvexCellGrid_h

#include "ConvexCellPlan.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkCellData;
class vtkIdTypeArray;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

/** Which fates the input's cells have. */
struct ConvexCellFates
{
  explicit ConvexCellFates(const std::vector<ConvexCellPlan>& plans = {});

  vtkIdType NumberOfCells = 0;
  bool AllWhole = true;
  bool AnyTetrahedra = false;
  bool AnyImaginary = false;
};

class ConvexCellGrid
{
public:
  ConvexCellGrid();
  ~ConvexCellGrid();

  /** `end`: where the last cell ends. */
  void Allocate(const ConvexCellCursor& end);
  /** To be written once. */
  ConvexCellArrays GetArrays();

  /** The cells without points; the same objects each time. Without polyhedra, the arrays become
   *  the grid's. */
  void FillCells(vtkUnstructuredGrid* output);
  /** Data of the input's cells, and SourceCell. */
  void FillCellData(vtkCellData* input, const ConvexCellFates& fates, vtkCellData* output) const;

  /** How many cells each of the input's cells became. */
  std::vector<int> CountBySource(vtkIdType inputCells) const;

private:
  void MakeCells();

  vtkNew<vtkUnsignedCharArray> Types;
  vtkNew<vtkIdTypeArray> Offsets;
  vtkNew<vtkIdTypeArray> Ids;
  vtkNew<vtkIdTypeArray> SourceCells;
  vtkSmartPointer<vtkUnstructuredGrid> Cells;
};

#endif
