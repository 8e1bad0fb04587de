#include "VisibilityGraph.h"

#include "Convexification.h"
#include "GapRelations.h"
#include "GroupOrder.h"
#include "ImaginaryCenters.h"
#include "MortonOrder.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>
#include <set>

//------------------------------------------------------------------------------
void VisibilityGraph::Build(const CellComplex& complex, const ImaginaryCells* imaginary)
{
  this->Points = &complex.Points;
  this->NumberOfMeshCells = complex.NumberOfCells;
  this->Centers = ImaginaryCenters::Append(complex, imaginary);
  // Imaginary cells may reach beyond the mesh.
  vtkBoundingBox box = complex.CenterBox;
  for (size_t i = complex.Centers.size(); i < this->Centers.size(); i += 3)
  {
    box.AddPoint(this->Centers[i], this->Centers[i + 1], this->Centers[i + 2]);
  }
  this->NumberCells(box);
  this->TakeContacts(complex, imaginary);
  this->LinkCells();
  double center[3] = { 0.0, 0.0, 0.0 };
  if (box.IsValid())
  {
    box.GetCenter(center);
  }
  this->Signs.Build(
    complex.Points, this->Contacts, center, box.IsValid() ? box.GetDiagonalLength() : 0.0);
  this->Sorted = false;
}

//------------------------------------------------------------------------------
void VisibilityGraph::NumberCells(const vtkBoundingBox& box)
{
  this->InputId = MortonOrder::Find(this->Centers, box);
  std::stable_partition(this->InputId.begin(), this->InputId.end(),
    [this](int input) { return input < this->NumberOfMeshCells; });
  std::vector<double> centers(this->Centers.size());
  for (size_t own = 0; own < this->InputId.size(); ++own)
  {
    std::copy_n(&this->Centers[3 * static_cast<size_t>(this->InputId[own])], 3, &centers[3 * own]);
  }
  this->Centers.swap(centers);
}

//------------------------------------------------------------------------------
void VisibilityGraph::TakeContacts(const CellComplex& complex, const ImaginaryCells* imaginary)
{
  std::vector<CellComplex::Contact> contacts = complex.Contacts;
  if (imaginary)
  {
    contacts.insert(contacts.end(), imaginary->Contacts.begin(), imaginary->Contacts.end());
  }
  std::vector<int> ownId(this->InputId.size());
  for (size_t own = 0; own < ownId.size(); ++own)
  {
    ownId[this->InputId[own]] = static_cast<int>(own);
  }
  // By the first of their cells, so that contacts lie in memory as their cells do.
  std::vector<int> next(this->InputId.size() + 1, 0);
  for (CellComplex::Contact& contact : contacts)
  {
    contact.Cells[0] = ownId[contact.Cells[0]];
    contact.Cells[1] = ownId[contact.Cells[1]];
    ++next[std::min(contact.Cells[0], contact.Cells[1]) + 1];
  }
  for (size_t i = 1; i < next.size(); ++i)
  {
    next[i] += next[i - 1];
  }
  this->Contacts.resize(contacts.size());
  for (const CellComplex::Contact& contact : contacts)
  {
    this->Contacts[next[std::min(contact.Cells[0], contact.Cells[1])]++] = contact;
  }
}

//------------------------------------------------------------------------------
void VisibilityGraph::LinkCells()
{
  const size_t cells = this->InputId.size();
  this->LinkOffsets.assign(cells + 1, 0);
  for (const CellComplex::Contact& contact : this->Contacts)
  {
    ++this->LinkOffsets[contact.Cells[0] + 1];
    ++this->LinkOffsets[contact.Cells[1] + 1];
  }
  std::partial_sum(this->LinkOffsets.begin(), this->LinkOffsets.end(), this->LinkOffsets.begin());
  std::vector<int> next = this->LinkOffsets;
  this->Links.resize(2 * this->Contacts.size());
  for (int i = 0; i < static_cast<int>(this->Contacts.size()); ++i)
  {
    for (int side = 0; side < 2; ++side)
    {
      const int cell = this->Contacts[i].Cells[side];
      this->Links[next[cell]++] = { this->Contacts[i].Cells[1 - side], 2 * i + side };
    }
  }
  this->LongLists.resize(this->Links.size());
  this->Cells.resize(cells);
}

//------------------------------------------------------------------------------
bool VisibilityGraph::Sort(const double eye[4], bool centersFirst)
{
  const bool changed = this->Signs.Update(this->Contacts, eye);
  // What the centres tell apart changes without a sign.
  if (this->Sorted && !changed && !centersFirst && !this->SortedByCenters)
  {
    return false;
  }
  this->Sorted = true;
  this->SortedByCenters = centersFirst;
  this->GroupCells.clear();
  this->GroupOffsets.assign(1, 0);
  this->FindNearer();
  this->FindSources(eye, centersFirst);
  this->OwnOrder.resize(static_cast<size_t>(this->NumberOfMeshCells));
  this->NumberOrdered = 0;
  this->SortTopologically();
  if (this->NumberOrdered < this->NumberOfMeshCells)
  {
    this->SortGroups(eye);
  }
  this->TakeInputIds();
  return true;
}

//------------------------------------------------------------------------------
void VisibilityGraph::FindNearer()
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Cells.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        this->FindNearer(cell);
      }
    });
}

//------------------------------------------------------------------------------
void VisibilityGraph::FindNearer(vtkIdType cell)
{
  const int first = this->LinkOffsets[cell];
  const int last = this->LinkOffsets[cell + 1];
  Cell& own = this->Cells[cell];
  int few[4] = { 0, 0, 0, 0 };
  int* list = last - first <= 4 ? few : &this->LongLists[first];
  int nearer = 0;
  int farther = 0;
  for (int link = first; link < last; ++link)
  {
    const int across = this->CompareAcross(link);
    farther += across < 0 ? 1 : 0;
    // Written in any case, kept where it counts: no branch to guess.
    list[nearer] = this->Links[link].Neighbor;
    nearer += across > 0 ? 1 : 0;
  }
  if (nearer > 3)
  {
    std::copy_n(list, nearer, &this->LongLists[first]);
    own = { farther * WaitingUnit + LongList, { first, first + nearer, 0 } };
    return;
  }
  own.State = farther * WaitingUnit + nearer;
  // All three, for a fixed number is copied without a loop.
  std::copy_n(list, 3, own.Nearer);
}

//------------------------------------------------------------------------------
void VisibilityGraph::FindSources(const double eye[4], bool centersFirst)
{
  this->Stack.clear();
  for (int cell = 0; cell < static_cast<int>(this->InputId.size()); ++cell)
  {
    if (!this->IsWaiting(cell))
    {
      this->Stack.push_back(cell);
    }
  }
  if (centersFirst)
  {
    // The stack's end is taken first.
    std::sort(this->Stack.begin(), this->Stack.end(),
      [&](int a, int b) { return this->GetDistance(a, eye) < this->GetDistance(b, eye); });
  }
}

//------------------------------------------------------------------------------
double VisibilityGraph::GetDistance(int cell, const double eye[4]) const
{
  const double* center = &this->Centers[3 * static_cast<size_t>(cell)];
  return eye[3] == 0.0 ? -vtkMath::Dot(center, eye) : vtkMath::Distance2BetweenPoints(center, eye);
}

//------------------------------------------------------------------------------
void VisibilityGraph::SortTopologically()
{
  // Plain pointers: this loop is most of the time that a frame takes.
  const size_t sources = this->Stack.size();
  this->Stack.resize(this->InputId.size() + 1);
  int* top = this->Stack.data() + sources;
  int* ordered = this->OwnOrder.data() + this->NumberOrdered;
  Cell* cells = this->Cells.data();
  while (top != this->Stack.data())
  {
    const int cell = *--top;
    if (this->IsMeshCell(cell))
    {
      *ordered++ = cell;
    }
    const Cell& own = cells[cell];
    const int* nearer = own.Nearer;
    const int* end = nearer + own.State;
    if (own.State == LongList)
    {
      nearer = &this->LongLists[0] + own.Nearer[0];
      end = &this->LongLists[0] + own.Nearer[1];
    }
    for (; nearer != end; ++nearer)
    {
      if ((cells[*nearer].State -= WaitingUnit) < WaitingUnit)
      {
        *top++ = *nearer;
      }
    }
  }
  this->Stack.clear();
  this->NumberOrdered = static_cast<int>(ordered - this->OwnOrder.data());
}

//------------------------------------------------------------------------------
void VisibilityGraph::TakeInputIds()
{
  this->Order.resize(this->OwnOrder.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Order.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->Order[i] = this->InputId[this->OwnOrder[i]];
      }
    });
}

//------------------------------------------------------------------------------
void VisibilityGraph::AppendGroup(std::vector<int>& group, const double eye[4])
{
  std::sort(group.begin(), group.end(),
    [&](int a, int b) { return this->GetDistance(a, eye) > this->GetDistance(b, eye); });
  const auto imaginary = std::stable_partition(
    group.begin(), group.end(), [this](int cell) { return this->IsMeshCell(cell); });
  std::unordered_map<int, int> placeOf;
  for (auto cell = group.begin(); cell != imaginary; ++cell)
  {
    placeOf.emplace(*cell, static_cast<int>(placeOf.size()));
  }
  std::vector<std::pair<int, int>> relations = this->FindRelations(group, placeOf);
  if (imaginary != group.end())
  {
    // That three cells follow each other through gaps does not mean that a ray meets the first and
    // the last: without the imaginary cells most circles are none.
    const std::vector<std::pair<int, int>> gaps = this->FindGapRelations(placeOf, eye);
    relations.insert(relations.end(), gaps.begin(), gaps.end());
  }
  for (const std::vector<int>& circle :
    GroupOrder::Find(static_cast<int>(placeOf.size()), relations))
  {
    for (const int place : circle)
    {
      this->OwnOrder[this->NumberOrdered++] = group[place];
      if (circle.size() > 1)
      {
        this->GroupCells.push_back(this->InputId[group[place]]);
      }
    }
    if (circle.size() > 1)
    {
      this->GroupOffsets.push_back(static_cast<vtkIdType>(this->GroupCells.size()));
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::pair<int, int>> VisibilityGraph::FindRelations(
  const std::vector<int>& group, const std::unordered_map<int, int>& placeOf) const
{
  std::vector<std::pair<int, int>> relations;
  for (int place = 0; place < static_cast<int>(placeOf.size()); ++place)
  {
    const int cell = group[place];
    for (int link = this->LinkOffsets[cell]; link < this->LinkOffsets[cell + 1]; ++link)
    {
      const auto nearer = placeOf.find(this->Links[link].Neighbor);
      if (nearer != placeOf.end() && this->CompareAcross(link) > 0)
      {
        relations.emplace_back(place, nearer->second);
      }
    }
  }
  return relations;
}

//------------------------------------------------------------------------------
std::vector<std::pair<int, int>> VisibilityGraph::FindGapRelations(
  const std::unordered_map<int, int>& placeOf, const double eye[4]) const
{
  std::vector<GapTriangle> far, near;
  std::set<std::array<int, 4>> seen;
  for (const auto& cell : placeOf)
  {
    for (int link = this->LinkOffsets[cell.first]; link < this->LinkOffsets[cell.first + 1]; ++link)
    {
      const int across = this->CompareAcross(link);
      const int* p = this->Contacts[this->Links[link].ContactAndSide >> 1].Points;
      // A triangle may touch several imaginary cells.
      if (!this->IsMeshCell(this->Links[link].Neighbor) && across != 0 &&
          seen.insert(std::array<int, 4>{ { p[0], p[1], p[2], cell.second } }).second)
      {
        (across > 0 ? far : near).push_back({ { p[0], p[1], p[2] }, cell.second });
      }
    }
  }
  return GapRelations::Find(this->Points->data(), far, near, eye);
}

//------------------------------------------------------------------------------
void VisibilityGraph::SortGroups(const double eye[4])
{
  // What is left waits for a circle. Walked from near to far, the first circle found has nothing
  // but placed cells behind it; once it is placed the sort goes on, and most of the rest with it.
  this->Components.Reset(static_cast<int>(this->InputId.size()));
  const auto getEdge = [&](int cell, int edge)
  {
    const int link = this->LinkOffsets[cell] + edge;
    if (link >= this->LinkOffsets[cell + 1])
    {
      return -2;
    }
    const int neighbor = this->Links[link].Neighbor;
    return this->CompareAcross(link) < 0 && this->IsWaiting(neighbor) ? neighbor : -1;
  };
  for (int cell = 0; cell < static_cast<int>(this->InputId.size()); ++cell)
  {
    if (this->IsWaiting(cell) && !this->Components.HasSeen(cell))
    {
      this->Components.Walk(
        cell, getEdge, [this](int placed) { return !this->IsWaiting(placed); },
        [&](std::vector<int>& group)
        {
          this->AppendGroup(group, eye);
          this->Release(group);
          this->SortTopologically();
        });
    }
  }
}

//------------------------------------------------------------------------------
void VisibilityGraph::Release(const std::vector<int>& group)
{
  for (const int cell : group)
  {
    this->Cells[cell].State %= WaitingUnit;
  }
  for (const int cell : group)
  {
    for (int link = this->LinkOffsets[cell]; link < this->LinkOffsets[cell + 1]; ++link)
    {
      const int neighbor = this->Links[link].Neighbor;
      if (this->CompareAcross(link) > 0 && this->IsWaiting(neighbor))
      {
        this->Cells[neighbor].State -= WaitingUnit;
        if (!this->IsWaiting(neighbor))
        {
          this->Stack.push_back(neighbor);
        }
      }
    }
  }
}
