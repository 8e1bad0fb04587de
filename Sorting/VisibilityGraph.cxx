#include "VisibilityGraph.h"

#include "Convexification.h"
#include "GapRelations.h"
#include "GroupOrder.h"
#include "ImaginaryCenters.h"
#include "MortonOrder.h"

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
  this->Links.Build(this->Contacts, static_cast<int>(this->InputId.size()));
  double center[3] = { 0.0, 0.0, 0.0 };
  if (box.IsValid())
  {
    box.GetCenter(center);
  }
  this->CellSort.Build(
    this->Links, this->Centers, center, this->InputId, this->NumberOfMeshCells);
  this->Links.Signs.Build(
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
bool VisibilityGraph::Sort(const double eye[4], bool centersFirst)
{
  const bool changed = this->Links.Signs.Update(this->Contacts, eye);
  // What the centres tell apart changes without a sign.
  if (this->Sorted && !changed && !centersFirst && !this->SortedByCenters)
  {
    return false;
  }
  this->Sorted = true;
  this->SortedByCenters = centersFirst;
  this->GroupCells.clear();
  this->GroupOffsets.assign(1, 0);
  this->CellSort.Sort(eye, centersFirst);
  if (this->CellSort.HasRest())
  {
    this->SortGroups(eye);
  }
  return true;
}

//------------------------------------------------------------------------------
void VisibilityGraph::AppendGroup(std::vector<int>& group, const double eye[4])
{
  std::sort(group.begin(), group.end(),
    [&](int a, int b)
    { return this->CellSort.GetDistance(a, eye) > this->CellSort.GetDistance(b, eye); });
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
      this->CellSort.Append(group[place]);
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
    for (int link = this->Links.Begin(cell); link < this->Links.End(cell); ++link)
    {
      const auto nearer = placeOf.find(this->Links.GetNeighbor(link));
      if (nearer != placeOf.end() && this->Links.CompareAcross(link) > 0)
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
    for (int link = this->Links.Begin(cell.first); link < this->Links.End(cell.first); ++link)
    {
      const int across = this->Links.CompareAcross(link);
      if (this->IsMeshCell(this->Links.GetNeighbor(link)) || across == 0)
      {
        continue;
      }
      // A triangle may touch several imaginary cells.
      const int* p = this->Contacts[this->Links.GetContact(link)].Points;
      if (seen.insert(std::array<int, 4>{ { p[0], p[1], p[2], cell.second } }).second)
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
    const int link = this->Links.Begin(cell) + edge;
    if (link >= this->Links.End(cell))
    {
      return -2;
    }
    const int neighbor = this->Links.GetNeighbor(link);
    return this->Links.CompareAcross(link) < 0 && this->CellSort.IsWaiting(neighbor) ? neighbor
                                                                                     : -1;
  };
  for (int cell = 0; cell < static_cast<int>(this->InputId.size()); ++cell)
  {
    if (this->CellSort.IsWaiting(cell) && !this->Components.HasSeen(cell))
    {
      this->Components.Walk(
        cell, getEdge, [this](int placed) { return !this->CellSort.IsWaiting(placed); },
        [&](std::vector<int>& group)
        {
          this->AppendGroup(group, eye);
          this->CellSort.Release(group);
        });
    }
  }
}
