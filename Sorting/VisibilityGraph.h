/**
 * Which cells hide which, for an eye, and an order of the cells from it.
 *
 * Paper: Williams, Visibility Ordering Meshed Polyhedra, 1992. Each contact has one sign: the side
 * of its plane on which the eye lies. From a float plane with a bound on its error; where the bound
 * does not decide, exactly. A contact seen edge-on orders nothing. The order is a topological sort,
 * of the far half of the cells from the farthest on and of the near half from the nearest on, both
 * at once: what either reaches without the other is in order, and what is left, about where the
 * halves meet, is sorted between them. Cells that are left over then hide each other in circles, or
 * lie behind such a circle, and are ordered by the groups of Tarjan's algorithm. The order does not
 * depend on the threads.
 *
 * Cells and contacts are put in Morton order of their centres once: a sort over shuffled cells
 * would run an order of magnitude slower.
 */
#ifndef VisibilityGraph_h
#define VisibilityGraph_h

#include "CellComplex.h"
#include "SignedLinks.h"
#include "StrongComponents.h"
#include "TwoEndedSort.h"
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
   *  is 0. Cells that nothing tells apart come by their centres where `centersFirst` says so
   *  (meshes that are not convex), anew for every eye: from the farthest on, and from the nearest
   *  on. Else false where no sign has changed since the last call, and with it the order. */
  bool Sort(const double eye[4], bool centersFirst);

  /** Ids of the complex's cells, farthest first; imaginary cells are not among them. */
  const std::vector<vtkIdType>& GetOrder() const { return this->CellSort.GetOrder(); }

  /** Groups that no order satisfies: cells one after the other, and where each group begins, and
   *  the end. Farthest group first. */
  const std::vector<vtkIdType>& GetGroupCells() const { return this->GroupCells; }
  const std::vector<vtkIdType>& GetGroupOffsets() const { return this->GroupOffsets; }

private:
  void NumberCells(const vtkBoundingBox& box);
  void TakeContacts(const CellComplex& complex, const ImaginaryCells* imaginary);
  void SortGroups(const double eye[4]);
  void AppendGroup(std::vector<int>& group, const double eye[4]);
  std::vector<std::pair<int, int>> FindRelations(
    const std::vector<int>& group, const std::unordered_map<int, int>& placeOf) const;
  std::vector<std::pair<int, int>> FindGapRelations(
    const std::unordered_map<int, int>& placeOf, const double eye[4]) const;
  bool IsMeshCell(int cell) const { return cell < this->NumberOfMeshCells; }

  const std::vector<double>* Points = nullptr;
  int NumberOfMeshCells = 0;

  // Cells by the graph's own numbers: those of the mesh first.
  std::vector<double> Centers;
  std::vector<int> InputId;
  std::vector<CellComplex::Contact> Contacts;
  SignedLinks Links;
  TwoEndedSort CellSort;
  StrongComponents Components;
  bool Sorted = false;
  bool SortedByCenters = false;

  std::vector<vtkIdType> GroupCells;
  std::vector<vtkIdType> GroupOffsets;
};

#endif
