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
#include "vtkType.h"

#include <vector>

struct ImaginaryCells;

class VisibilityGraph
{
public:
  /** The complex must stay as it is while the graph is used. `imaginary` may be null. */
  void Build(const CellComplex& complex, const ImaginaryCells* imaginary);

  /** Orders the cells for an eye: a point where eye[3] is 1, a direction towards the eye where it
   *  is 0. Cells that nothing tells apart come from the farthest centre on where `centersFirst`
   *  says so (meshes that are not convex). False where no sign has changed since the last call, and
   *  with it the order. */
  bool Sort(const double eye[4], bool centersFirst);

  /** Ids of the complex's cells, farthest first; imaginary cells are not among them. */
  const std::vector<vtkIdType>& GetOrder() const { return this->Order; }

  /** Groups that no order satisfies: cells one after the other, and where each group begins, and
   *  the end. Farthest group first. */
  const std::vector<vtkIdType>& GetGroupCells() const { return this->GroupCells; }
  const std::vector<vtkIdType>& GetGroupOffsets() const { return this->GroupOffsets; }

private:
  /** A plane about the middle of the mesh, in units of its size. */
  struct Plane
  {
    float Normal[3];
    float Offset;
  };
  /** One side of a contact: the cell across it, and the contact with its side in the last bit. */
  struct Link
  {
    int Neighbor;
    int ContactAndSide;
  };

  void TakeCenters(const CellComplex& complex, const ImaginaryCells* imaginary);
  void NumberCells();
  void TakeContacts(const CellComplex& complex, const ImaginaryCells* imaginary);
  void LinkCells();
  void SetPlanes();

  bool FindSigns(const double eye[4]);
  signed char SignOf(int contact, const float eye[4], float scale, const double exact[4]) const;
  void CountFarther();
  void FindSources(const double eye[4], bool centersFirst);
  void SortTopologically();
  void SortGroups(const double eye[4]);
  void AppendGroup(std::vector<int>& group, const double eye[4]);
  void Emit(int cell);
  /** Whether the cell across is nearer to the eye. */
  bool IsNearer(const Link& link) const
  {
    const signed char sign = this->Signs[link.ContactAndSide >> 1];
    return (link.ContactAndSide & 1) != 0 ? sign > 0 : sign < 0;
  }
  bool IsFarther(const Link& link) const
  {
    const signed char sign = this->Signs[link.ContactAndSide >> 1];
    return (link.ContactAndSide & 1) != 0 ? sign < 0 : sign > 0;
  }
  double GetDistance(int cell, const double eye[4]) const;

  const std::vector<double>* Points = nullptr;
  int NumberOfMeshCells = 0;
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Scale = 1.0;

  // Cells by the graph's own numbers.
  std::vector<double> Centers;
  std::vector<int> InputId;
  std::vector<int> OwnId;
  std::vector<CellComplex::Contact> Contacts;
  std::vector<Plane> Planes;
  std::vector<Link> Links;
  std::vector<int> LinkOffsets;

  std::vector<signed char> Signs;
  std::vector<int> Waiting;
  std::vector<int> Stack;
  bool Sorted = false;
  bool SortedByCenters = false;

  std::vector<vtkIdType> Order;
  std::vector<vtkIdType> GroupCells;
  std::vector<vtkIdType> GroupOffsets;
};

#endif
