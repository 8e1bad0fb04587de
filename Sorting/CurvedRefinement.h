/**
 * Curved cells as tetrahedra that follow them within a tolerance, and agree with their neighbours.
 *
 * The linear twin of a curved cell is split by TetrahedralSplit; then, pass by pass, edges that are
 * off are halved at points of the curved cell (CurvedError, MarkedEdges). Straight neighbours of
 * halved edges follow. Not guaranteed: that cells are not folded where their map is.
 */
#ifndef CurvedRefinement_h
#define CurvedRefinement_h

#include "CurvedError.h"
#include "MarkedEdges.h"

#include "vtkSMPThreadLocal.h"

#include <memory>
#include <set>
#include <vector>

class ConvexCellPoints;
class vtkUnstructuredGrid;

class CurvedRefinement
{
public:
  using Tetrahedron = MarkedEdges::Tetrahedron;

  /** What is shorter in reference coordinates is not halved, nor anything after so many passes, nor
   *  in a cell of so many pieces: wild cells would have no end. */
  static constexpr double ShortestEdge = 1.0 / 256.0;
  static constexpr int MaximumPasses = 20;
  static constexpr int MaximumPieces = 20000;

  CurvedRefinement(vtkUnstructuredGrid* grid, ConvexCellPoints& points,
    const std::vector<vtkDataArray*>& arrays, double tolerance);
  ~CurvedRefinement();

  /** `ids`: the points of the cell as they go by, those of the twin first. */
  void AddCurved(vtkIdType cell, TetrahedralSplit::Shape twin, const vtkIdType* ids);

  /** By input point: a curved cell's edge is halved at its node where that is one of these, as
   *  polyhedra have it in their faces. Before the first pass. */
  void HalveAt(const std::vector<char>& nodes) { this->Nodes = nodes; }

  // === One pass: mark, add the straight cells that share a marked edge, cut

  /** False where nothing is left to halve. */
  bool Mark();
  bool IsMarked(vtkIdType a, vtkIdType b) const { return this->Edges.IsMarked(a, b); }
  /** What halves the edge; -1 where it is not marked. */
  vtkIdType GetMiddle(vtkIdType a, vtkIdType b) const { return this->Edges.GetMiddle(a, b); }
  /** By input point: whether a marked edge ends there. */
  const std::vector<char>& GetTouched() const { return this->Touched; }
  /** A piece of a straight cell. */
  void AddStraight(vtkIdType cell, const std::array<vtkIdType, 4>& ids);
  void Cut();

  // === After the last

  /** The pieces of those cells that were cut, in the order of the cells. */
  std::vector<Tetrahedron> TakePieces();
  /** Cells that are off and were let be. */
  vtkIdType GetNumberOfCoarseCells() const
  {
    return static_cast<vtkIdType>(this->CoarseCells.size());
  }

private:
  struct Place
  {
    std::size_t Tetrahedron;
    int Edge;
  };
  CurvedError& GetError();
  std::vector<Place> FindOffEdges();
  std::vector<Place> FindOffInsides();
  void CountPieces();
  bool IsToHalve(const Place& place);
  std::size_t HalveAtNodes();
  void Halve(const Place& place);
  CurvedCell::Coordinates MiddleOf(const Place& place) const;
  vtkIdType FindNode(const Tetrahedron& tetrahedron, const CurvedCell::Coordinates& x);
  vtkIdType FindOrAddPoint(
    const Tetrahedron& tetrahedron, const CurvedCell::Coordinates& reference);

  vtkUnstructuredGrid* Grid;
  ConvexCellPoints& Points;
  const CurvedTolerance Tolerance;
  vtkSMPThreadLocal<std::shared_ptr<CurvedError>> Errors;
  CurvedCell Cell;
  MarkedEdges Edges;
  std::vector<Tetrahedron> Tetrahedra;
  std::vector<int> Roots;  // by cell: how many pieces it began with
  std::vector<int> Counts; // by cell: how many it has
  std::vector<char> Touched;
  std::vector<char> Nodes; // empty or by input point
  int Pass = 0;
  std::set<vtkIdType> CoarseCells;
};

#endif
