/**
 * One run of vtkConvexCells: reads the mesh, plans each cell, writes the output's arrays.
 *
 * Passes, in the order of the methods: 1 merge points, 2 plan cells, 3 allocate, 4 write, 5 fill
 * the output. Passes 2 and 4 work on blocks of cells, in parallel, each block writing at its own
 * place in the output: the result does not depend on the threads. The algorithms are in
 * CoincidentPoints, ConvexCellPlan, PolyhedronPlan, ConvexityTest and TetrahedralSplit.
 */
#ifndef ConvexCellConversion_h
#define ConvexCellConversion_h

#include "ConvexCellCounts.h"
#include "ConvexCellPlan.h"
#include "ConvexCellReader.h"
#include "PointCoordinates.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkIdList;
class vtkIdTypeArray;
class vtkPoints;
class vtkUnsignedCharArray;
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
  void PlanBlocks(vtkIdType begin, vtkIdType end);  // what becomes of each cell
  void AllocateCells();                             // where each block begins in the output
  void WriteBlocks(vtkIdType begin, vtkIdType end); // cells and SourceCell
  void FillOutput(vtkUnstructuredGrid* output);     // points and data
  ConvexCellCounts Count() const;

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

  ConvexCellCut FindCut(int type) const;
  ConvexCellPlan PlanCell(vtkIdType cell, Scratch& scratch, ConvexCellCursor& cursor) const;
  ConvexCellPlan PlanPolyhedronCell(
    vtkIdType cell, Scratch& scratch, ConvexCellCursor& cursor) const;
  void WriteCell(vtkIdType cell, Scratch& scratch, const ConvexCellArrays& arrays,
    ConvexCellCursor& cursor) const;
  Coordinates* FetchPoints(const vtkIdType* ids, int count, Scratch& scratch) const;
  void NumberOutputPoints();
  void FillCells(vtkUnstructuredGrid* output);
  void FillPoints(vtkUnstructuredGrid* output);
  void FillCellData(vtkUnstructuredGrid* output) const;
  template <typename Visit>
  void VisitBlocks(vtkIdType begin, vtkIdType end, Visit visit);

  vtkUnstructuredGridBase* Input;
  const bool TetrahedraOnly;
  const vtkIdType NumberOfPoints;
  const vtkIdType NumberOfCells;
  const PointCoordinates Points;
  ConvexCellReader Reader;
  std::vector<vtkIdType> Canonical;    // by input point
  std::vector<vtkIdType> OutputIds;    // by input point; empty where nothing is merged or removed
  std::vector<vtkIdType> SourcePoints; // by output point; empty likewise
  vtkIdType NumberOfMergedPoints = 0;

  std::vector<ConvexCellPlan> Plans;         // by input cell
  std::vector<ConvexCellCursor> BlockStarts; // one more than there are blocks
  vtkNew<vtkUnsignedCharArray> OutputTypes;
  vtkNew<vtkIdTypeArray> Offsets;
  vtkNew<vtkIdTypeArray> Ids;
  vtkNew<vtkIdTypeArray> SourceCells;
  vtkSmartPointer<vtkUnstructuredGrid> OutputCells; // without points
  vtkSmartPointer<vtkPoints> OutputPoints;          // null where the input's are taken
};

#endif
