/**
 * Which cells hide which, for an eye, and an order of the cells from it.
 *
 * Paper: Williams, Visibility Ordering Meshed Polyhedra, 1992. Each contact has one sign: the side
 * of its plane on which the eye lies. From a float plane with a bound on its error; where the bound
 * does not decide, exactly. A contact seen edge-on orders nothing. The order is a topological sort
 * that takes the cell released last, so that it moves through neighbours in memory; cells that are
 * left over hide each other in circles, or lie behind such a circle, and are ordered by the groups
 * of Tarjan's algorithm.
 *
 * Cells and contacts are put in Morton order of their centres once: a sort over shuffled cells
 * would run an order of magnitude slower.
 */
#ifndef VisibilityGraph_h
#define VisibilityGraph_h

#include "CellComplex.h"
#include "ContactSigns.h"
#include "StrongComponents.h"
#include "vtkType.h"

#include <unordered_map>
#include <utility>
#include <vector>

struct ImaginaryCells;

class VisibilityGraph
{
public:
  /** The complex must stay as it is while the graph is used. `imaginary` may be null. */
  void Build(const CellComplex& complex, const ImaginaryCells* imaginary);

  /** Orders the cells for an eye: a point where eye[3] is 1, a direction towards the eye where it
   *  is 0. Cells that nothing tells apart come from the farthest centre on where `centersFirst`
   *  says so (meshes that are not convex), anew for every eye. Else false where no sign has changed
   *  since the last call, and with it the order. */
  bool Sort(const double eye[4], bool centersFirst);

  /** Ids of the complex's cells, farthest first; imaginary cells are not among them. */
  const std::vector<vtkIdType>& GetOrder() const { return this->Order; }

  /** Groups that no order satisfies: cells one after the other, and where each group begins, and
   *  the end. Farthest group first. */
  const std::vector<vtkIdType>& GetGroupCells() const { return this->GroupCells; }
  const std::vector<vtkIdType>& GetGroupOffsets() const { return this->GroupOffsets; }

private:
  /** What the sort touches of a cell, in a quarter of a line of the cache. */
  struct alignas(16) Cell
  {
    /** Farther neighbours that are not in the order yet, times WaitingUnit, plus the number of
     *  nearer ones; LongList instead of that number where they are more than three. */
    int State;
    /** The nearer neighbours; or where they begin and end in LongLists. */
    int Nearer[3];
  };
  /** A contact as one of its cells sees it. */
  struct Link
  {
    int Neighbor;
    /** The contact, with the cell's side in the last bit. */
    int ContactAndSide;
  };
  static constexpr int WaitingUnit = 8;
  static constexpr int LongList = 4;

  void NumberCells(const vtkBoundingBox& box);
  void TakeContacts(const CellComplex& complex, const ImaginaryCells* imaginary);
  void LinkCells();

  void FindNearer();
  void FindNearer(vtkIdType cell);
  bool IsWaiting(int cell) const { return this->Cells[cell].State >= WaitingUnit; }
  void FindSources(const double eye[4], bool centersFirst);
  void SortTopologically();
  void SortGroups(const double eye[4]);
  void Release(const std::vector<int>& group);
  void AppendGroup(std::vector<int>& group, const double eye[4]);
  std::vector<std::pair<int, int>> FindRelations(
    const std::vector<int>& group, const std::unordered_map<int, int>& placeOf) const;
  std::vector<std::pair<int, int>> FindGapRelations(
    const std::unordered_map<int, int>& placeOf, const double eye[4]) const;
  void TakeInputIds();
  bool IsMeshCell(int cell) const { return cell < this->NumberOfMeshCells; }
  /** 1 where the cell across a link is nearer to the eye, -1 where it is farther. */
  int CompareAcross(int link) const
  {
    const int contactAndSide = this->Links[link].ContactAndSide;
    const int sign = this->Signs[contactAndSide >> 1];
    return (contactAndSide & 1) != 0 ? sign : -sign;
  }
  double GetDistance(int cell, const double eye[4]) const;

  const std::vector<double>* Points = nullptr;
  int NumberOfMeshCells = 0;

  // Cells by the graph's own numbers: those of the mesh first.
  std::vector<double> Centers;
  std::vector<int> InputId;
  std::vector<CellComplex::Contact> Contacts;
  std::vector<int> LinkOffsets;
  std::vector<Link> Links;

  // Per frame. LongLists: the nearer neighbours of cells with many, from their link offset on.
  ContactSigns Signs;
  std::vector<Cell> Cells;
  std::vector<int> LongLists;
  std::vector<int> Stack;
  std::vector<int> OwnOrder;
  int NumberOrdered = 0;
  StrongComponents Components;
  bool Sorted = false;
  bool SortedByCenters = false;

  std::vector<vtkIdType> Order;
  std::vector<vtkIdType> GroupCells;
  std::vector<vtkIdType> GroupOffsets;
};

#endif
