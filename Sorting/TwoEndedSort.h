/**
 * A topological sort of cells from both ends at once.
 *
 * The far half of the cells is sorted from the farthest on, the near half from the nearest on, each
 * by a thread of its own. What the first reaches without the near half comes first in every order
 * that it begins, what the second reaches without the far half last: both are right, and what is
 * left, about where the halves meet, is sorted between them. What is left over then waits for a
 * circle. The halves are those of the direction nearest to the line of sight, so they do not depend
 * on the threads, nor does the order.
 *
 * Cells are numbered so that neighbours in space are neighbours in memory, those of the mesh first:
 * others are sorted, but are not in the order.
 */
#ifndef TwoEndedSort_h
#define TwoEndedSort_h

#include "SightHalves.h"
#include "SignedLinks.h"
#include "TopologicalSort.h"
#include "vtkType.h"

#include <vector>

class TwoEndedSort
{
public:
  /** All must stay as they are. `centers`: three per cell; `center`: of the mesh; `inputIds`: by
   *  which cells stand in the order. */
  void Build(const SignedLinks& links, const std::vector<double>& centers, const double center[3],
    const std::vector<int>& inputIds, int numberOfMeshCells);

  /** For the signs as they are. `centersFirst`: cells that nothing tells apart from the farthest
   *  centre on, in the near half from the nearest on. */
  void Sort(const double eye[4], bool centersFirst);

  /** Whether cells are left that wait for a circle, or lie behind one. */
  bool HasRest() const { return this->NumberOrdered < this->NearBegin; }
  bool IsWaiting(int cell) const { return this->Cells[cell].IsWaiting(); }

  /** Puts a cell of the mesh next into the order. */
  void Append(int cell) { this->Order[this->NumberOrdered++] = (*this->InputIds)[cell]; }
  /** Takes all cells of a circle for ordered, and sorts on. */
  void Release(const std::vector<int>& circle);

  /** Of a cell from the eye; its square for a point, to compare. */
  double GetDistance(int cell, const double eye[4]) const;

  /** Input ids of the cells of the mesh, farthest first. */
  const std::vector<vtkIdType>& GetOrder() const { return this->Order; }

private:
  /** What a thread finds in a run of cells. */
  struct Block
  {
    std::vector<int> Far;
    std::vector<int> Near;
  };
  template <class Work>
  void ForEachBlock(Work work);
  void ChooseHalves(const double eye[4]);
  bool IsFar(int cell) const
  {
    return (this->Halves[cell] & SightHalves::Positive) == this->FarSide;
  }
  void FindFewNext(int begin, int end);
  template <class Predicate>
  WaitingCell FindNext(int cell, int reversed, Predicate isListed, bool countsAll);
  void FindManyNext(int begin, int end);
  void FindNext();
  void FindRest();
  void SortByCenters(CellStack& stack, bool farthest, const double eye[4]) const;
  void SortHalf(bool far, const double eye[4], bool centersFirst);
  void SortRest(const double eye[4], bool centersFirst);
  void SortOn();

  const SignedLinks* Links = nullptr;
  const std::vector<double>* Centers = nullptr;
  double Center[3] = { 0.0, 0.0, 0.0 };
  const std::vector<int>* InputIds = nullptr;
  int NumberOfMeshCells = 0;
  SightHalves Sight;

  // Per eye. LongLists: the neighbours that a cell with many releases, from its first link on.
  const unsigned char* Halves = nullptr;
  unsigned char FarSide = 0;
  std::vector<Block> Blocks;
  std::vector<int> Rest;
  std::vector<WaitingCell> RestCells;
  std::vector<WaitingCell> Cells;
  std::vector<int> LongLists;
  CellStack Stack;
  CellStack NearStack;
  // Filled from both ends: what is between NumberOrdered and NearBegin is still to come.
  std::vector<vtkIdType> Order;
  int NumberOrdered = 0;
  int NearBegin = 0;
};

#endif
