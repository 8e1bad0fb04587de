/**
 * The curved cells of a mesh, and those straight ones next to them that had to follow, as
 * tetrahedra: CurvedRefinement for vtkConvexCells.
 */
#ifndef CurvedCells_h
#define CurvedCells_h

#include "ConvexCellPlan.h"
#include "CurvedRefinement.h"

#include <functional>
#include <vector>

class ConvexCellPoints;
class ConvexCellReader;
class StarCells;
class vtkDataArray;
class vtkIdList;
class vtkUnstructuredGrid;

class CurvedCells
{
public:
  /** `stars`: of the straight cells among them. */
  CurvedCells(const ConvexCellReader& reader, ConvexCellPoints& points, StarCells& stars);
  ~CurvedCells();

  static bool HasAny(const std::vector<unsigned char>& types);

  /** `goOn` is asked between the passes. False where it said no. */
  bool Refine(const std::vector<vtkDataArray*>& arrays, double tolerance,
    const std::function<bool()>& goOn);

  /** Of a curved cell, Whole where its points can be drawn. */
  ConvexCellPlan::FateType GetFate(vtkIdType cell) const { return this->Fates[cell]; }
  vtkIdType GetNumberOfCoarseCells() const { return this->NumberOfCoarseCells; }

  /** Whether the cell goes out as the tetrahedra below. */
  bool IsReplaced(vtkIdType cell) const { return this->Starts[cell] < this->Starts[cell + 1]; }
  /** visit(ids): four each. */
  template <typename Visit>
  void VisitPieces(vtkIdType cell, Visit visit) const
  {
    for (std::size_t piece = this->Starts[cell]; piece < this->Starts[cell + 1]; ++piece)
    {
      visit(this->Pieces[piece].data());
    }
  }

private:
  using Ids = std::array<vtkIdType, 4>;
  void AddCurved(CurvedRefinement& refinement);
  void AddCell(vtkIdType cell, CurvedCell& evaluator, CurvedRefinement& refinement);
  std::vector<char> FindNodes();
  void AddNeighbours(CurvedRefinement& refinement);
  bool IsNeighbour(const CurvedRefinement& refinement);
  void Split(vtkIdType cell, CurvedRefinement& refinement);
  void SplitPolyhedron(vtkIdType cell, CurvedRefinement& refinement);
  bool SplitByFaces(vtkIdType cell, const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
    CurvedRefinement& refinement);
  void TakePieces(const std::vector<CurvedRefinement::Tetrahedron>& pieces);

  const ConvexCellReader& Reader;
  ConvexCellPoints& Points;
  StarCells& Stars;
  vtkNew<vtkIdList> List;
  std::vector<vtkIdType> Canonical; // of the cell at hand
  std::vector<char> Taken;          // by cell
  std::vector<ConvexCellPlan::FateType> Fates;
  std::vector<std::size_t> Starts;
  std::vector<Ids> Pieces;
  vtkIdType NumberOfCoarseCells = 0;
};

#endif
