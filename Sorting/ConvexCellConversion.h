/**
 * One run of vtkConvexCells: reads the mesh, plans each cell, writes the output's arrays.
 *
 * Passes, in the order of the methods: 1 merge points, 2 refine curved cells, 3 plan cells,
 * 4 allocate, 5 write, 6 fill the output. Passes 3 and 5 work on blocks of cells, in parallel, each
 * block writing at its own place in the output: the result does not depend on the threads. The
 * algorithms are in CoincidentPoints, CurvedRefinement, ConvexCellPlan, PolyhedronPlan, ConePlan,
 * StarCell, ConvexityTest, TetrahedralSplit and FaceTriangles.
 */
#ifndef ConvexCellConversion_h
#define ConvexCellConversion_h

#include "ConvexCellCounts.h"
#include "ConvexCellGrid.h"
#include "ConvexCellPlan.h"
#include "ConvexCellPoints.h"
#include "ConvexCellReader.h"
#include "StarCells.h"

#include <functional>
#include <memory>
#include <vector>

class CurvedCells;
class vtkDataArray;
class vtkIdList;
class vtkTable;
class vtkUnstructuredGrid;
class vtkUnstructuredGridBase;

class ConvexCellConversion
{
public:
  ConvexCellConversion(vtkUnstructuredGridBase* input, bool tetrahedraOnly);
  ~ConvexCellConversion();

  vtkIdType GetNumberOfBlocks() const;

  void ReadCells();                                 // types, points, faces
  void MergePoints();                               // a canonical id per point, or why it has none
  bool HasCurvedCells() const;
  /** False where `goOn` said no. `arrays`: point data to follow within `tolerance`. */
  bool RefineCurvedCells(const std::vector<vtkDataArray*>& arrays, double tolerance,
    const std::function<bool()>& goOn);
  void PlanBlocks(vtkIdType begin, vtkIdType end);  // what becomes of each cell
  void AllocateCells();                             // where each block begins in the output
  void WriteBlocks(vtkIdType begin, vtkIdType end); // cells and SourceCell
  void FillOutput(vtkUnstructuredGrid* output);     // points and data
  ConvexCellCounts Count() const;
  void Report(vtkTable* report) const;

  /** Gives back what only the steps before FillOutput need. */
  void ReleaseWorkingMemory();

  /** FillOutput then takes the data of `input`, whose points, cells and their types are the same:
   *  the output's points and cells stay the objects they were. */
  void TakeDataFrom(vtkUnstructuredGridBase* input) { this->Input = input; }
  /** Whether the output's points are the input's, as many as `input` has. */
  bool SharesPointsOf(vtkUnstructuredGridBase* input) const;
  bool HasSameTypes(vtkUnstructuredGridBase* input) const
  {
    return this->Reader.HasSameTypes(input);
  }

private:
  using Coordinates = double[3];
  struct Scratch;

  ConvexCellCut FindCut(int type, const double (*points)[3]) const;
  ConvexCellPlan PlanCell(vtkIdType cell, Scratch& scratch, ConvexCellCursor& cursor);
  ConvexCellPlan PlanLinearCell(vtkIdType cell, Scratch& scratch, ConvexCellCursor& cursor);
  ConvexCellPlan PlanSurfaceCell(vtkIdType cell, Scratch& scratch, ConvexCellCursor& cursor);
  void PlanByFaces(vtkIdType cell, TetrahedralSplit::Shape shape, Scratch& scratch,
    ConvexCellPlan& plan, ConvexCellCursor& cursor);
  bool IsOfFaces(vtkIdType cell) const;
  void WriteCell(vtkIdType cell, Scratch& scratch, const ConvexCellArrays& arrays,
    ConvexCellCursor& cursor) const;
  void WriteLinearCell(vtkIdType cell, Scratch& scratch, const ConvexCellArrays& arrays,
    ConvexCellCursor& cursor) const;
  void WriteByFaces(vtkIdType cell, TetrahedralSplit::Shape shape, Scratch& scratch,
    const ConvexCellArrays& arrays, ConvexCellCursor& cursor) const;
  void WriteSurfaceCell(vtkIdType cell, Scratch& scratch, const ConvexCellArrays& arrays,
    ConvexCellCursor& cursor) const;
  Coordinates* FetchPoints(const vtkIdType* ids, int count, Scratch& scratch) const;
  template <typename Visit>
  void VisitBlocks(vtkIdType begin, vtkIdType end, Visit visit);

  vtkUnstructuredGridBase* Input;
  const bool TetrahedraOnly;
  const vtkIdType NumberOfCells;
  ConvexCellPoints Points;
  ConvexCellReader Reader;
  std::unique_ptr<CurvedCells> Curved; // null where there are none
  StarCells Stars;

  std::vector<ConvexCellPlan> Plans;         // by input cell
  ConvexCellFates Fates;
  bool IsCurved = false;
  std::vector<ConvexCellCursor> BlockStarts; // one more than there are blocks
  ConvexCellGrid Output;
};

#endif
