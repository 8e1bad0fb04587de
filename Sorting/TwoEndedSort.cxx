#include "TwoEndedSort.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
// Of a tetrahedron.
constexpr int FewLinks = 4;
}

//------------------------------------------------------------------------------
void TwoEndedSort::Build(const SignedLinks& links, const std::vector<double>& centers,
  const double center[3], int numberOfMeshCells)
{
  this->Links = &links;
  this->Centers = &centers;
  std::copy_n(center, 3, this->Center);
  this->NumberOfMeshCells = numberOfMeshCells;
  this->Cells.resize(static_cast<size_t>(links.GetNumberOfCells()));
  this->LongLists.resize(static_cast<size_t>(links.GetNumberOfLinks()));
  this->FindOctants();
  this->FindOwnHalf();
}

//------------------------------------------------------------------------------
void TwoEndedSort::FindOctants()
{
  const auto cells = static_cast<vtkIdType>(this->Cells.size());
  this->Octants.assign(this->Cells.size(), 0);
  std::vector<double> along(this->Cells.size());
  for (int axis = 0; axis < 3 && cells > 0; ++axis)
  {
    for (vtkIdType cell = 0; cell < cells; ++cell)
    {
      along[cell] = (*this->Centers)[3 * cell + axis];
    }
    std::nth_element(along.begin(), along.begin() + cells / 2, along.end());
    const double median = along[cells / 2];
    for (vtkIdType cell = 0; cell < cells; ++cell)
    {
      this->Octants[cell] |= ((*this->Centers)[3 * cell + axis] >= median ? 1 : 0) << axis;
    }
  }
}

//------------------------------------------------------------------------------
void TwoEndedSort::FindOwnHalf()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<unsigned char>& own = this->OwnHalf[axis];
    own.assign(this->Cells.size(), 0);
    for (int cell = 0; cell < static_cast<int>(own.size()); ++cell)
    {
      const int first = this->Links->Begin(cell);
      const int count = std::min(this->Links->End(cell) - first, FewLinks);
      for (int i = 0; i < count; ++i)
      {
        const int octants =
          this->Octants[cell] ^ this->Octants[this->Links->GetNeighbor(first + i)];
        own[cell] |= static_cast<unsigned char>((~octants >> axis & 1) << i);
      }
    }
  }
}

//------------------------------------------------------------------------------
void TwoEndedSort::ChooseHalves(const double eye[4], bool centersFirst)
{
  double towards[3];
  for (int i = 0; i < 3; ++i)
  {
    towards[i] = eye[i] - eye[3] * this->Center[i];
  }
  const auto isSmaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  this->HalfAxis = static_cast<int>(std::max_element(towards, towards + 3, isSmaller) - towards);
  this->FarBit = towards[this->HalfAxis] > 0.0 ? 0 : 1;
  if (centersFirst)
  {
    // No octant has this bit: all cells are the far half, and come from their farthest on.
    this->HalfAxis = 3;
    this->FarBit = 0;
  }
}

//------------------------------------------------------------------------------
void TwoEndedSort::FindFewNext(int cell, int direction, int listed)
{
  const int first = this->Links->Begin(cell);
  const int last = this->Links->End(cell);
  WaitingCell& own = this->Cells[cell];
  int count = 0;
  int before = 0;
  for (int link = first; link < last; ++link, listed >>= 1)
  {
    const int across = direction * this->Links->CompareAcross(link);
    before += across < 0 ? 1 : 0;
    // Written in any case, kept where it counts: no branch to guess.
    own.Next[count] = this->Links->GetNeighbor(link);
    count += (across > 0 ? 1 : 0) & listed;
  }
  own.State() = before * WaitingCell::Unit + count;
}

//------------------------------------------------------------------------------
template <class Predicate>
WaitingCell TwoEndedSort::FindNext(int cell, int direction, Predicate isListed, bool countsAll)
{
  const int first = this->Links->Begin(cell);
  const int last = this->Links->End(cell);
  int* list = &this->LongLists[first];
  int next = 0;
  int before = 0;
  for (int link = first; link < last; ++link)
  {
    const int across = direction * this->Links->CompareAcross(link);
    const int neighbor = this->Links->GetNeighbor(link);
    const bool listed = isListed(neighbor);
    before += across < 0 && (countsAll || listed) ? 1 : 0;
    // Written in any case, kept where it counts: no branch to guess.
    list[next] = neighbor;
    next += across > 0 && listed ? 1 : 0;
  }
  if (next > 3)
  {
    return { { first, first + next, 0, before * WaitingCell::Unit + WaitingCell::LongList } };
  }
  WaitingCell own{ { 0, 0, 0, before * WaitingCell::Unit + next } };
  std::copy_n(list, next, own.Next);
  return own;
}

//------------------------------------------------------------------------------
void TwoEndedSort::FindNextInHalf(int cell)
{
  const bool far = this->IsFar(cell);
  const int direction = far ? 1 : -1;
  if (this->Links->End(cell) - this->Links->Begin(cell) <= FewLinks)
  {
    const int listed = this->HalfAxis < 3 ? this->OwnHalf[this->HalfAxis][cell] : ~0;
    this->FindFewNext(cell, direction, listed);
    if (this->Cells[cell].State() % WaitingCell::Unit < WaitingCell::LongList)
    {
      return;
    }
  }
  this->Cells[cell] = this->FindNext(
    cell, direction, [&](int neighbor) { return this->IsFar(neighbor) == far; }, true);
}

//------------------------------------------------------------------------------
void TwoEndedSort::FindNext()
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Cells.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cell = static_cast<int>(begin); cell < end; ++cell)
      {
        this->FindNextInHalf(cell);
      }
    });
}

//------------------------------------------------------------------------------
void TwoEndedSort::TakeSources(bool far, std::vector<int>& stack)
{
  stack.clear();
  for (int cell = 0; cell < static_cast<int>(this->Cells.size()); ++cell)
  {
    if (this->IsFar(cell) == far && !this->IsWaiting(cell))
    {
      stack.push_back(cell);
    }
  }
}

//------------------------------------------------------------------------------
double TwoEndedSort::GetDistance(int cell, const double eye[4]) const
{
  const double* center = &(*this->Centers)[3 * static_cast<size_t>(cell)];
  return eye[3] == 0.0 ? -vtkMath::Dot(center, eye) : vtkMath::Distance2BetweenPoints(center, eye);
}

//------------------------------------------------------------------------------
void TwoEndedSort::SortHalf(bool far, const double eye[4], bool centersFirst)
{
  std::vector<int>& stack = far ? this->Stack : this->NearStack;
  this->TakeSources(far, stack);
  if (centersFirst)
  {
    // The stack's end is taken first.
    std::sort(stack.begin(), stack.end(),
      [&](int a, int b) { return this->GetDistance(a, eye) < this->GetDistance(b, eye); });
  }
  int* const begin = this->Order.data();
  int* const from = far ? begin : begin + this->NumberOfMeshCells - 1;
  int* const to = TopologicalSort::Run(
    this->Cells, this->LongLists, stack, this->NumberOfMeshCells, from, far ? 1 : -1);
  (far ? this->NumberOrdered : this->NearBegin) = static_cast<int>(to - begin) + (far ? 0 : 1);
}

//------------------------------------------------------------------------------
void TwoEndedSort::Sort(const double eye[4], bool centersFirst)
{
  this->ChooseHalves(eye, centersFirst);
  this->FindNext();
  this->Order.resize(static_cast<size_t>(this->NumberOfMeshCells));
  vtkSMPTools::For(0, 2, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType half = begin; half < end; ++half)
      {
        this->SortHalf(half == 0, eye, centersFirst);
      }
    });
  this->SortRest();
}

//------------------------------------------------------------------------------
void TwoEndedSort::SortRest()
{
  std::vector<int> rest;
  for (int cell = 0; cell < static_cast<int>(this->Cells.size()); ++cell)
  {
    if (this->IsWaiting(cell))
    {
      rest.push_back(cell);
    }
  }
  std::vector<WaitingCell> cells(rest.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(rest.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        cells[i] = this->FindNext(
          rest[i], 1, [this](int neighbor) { return this->IsWaiting(neighbor); }, false);
      }
    });
  for (size_t i = 0; i < rest.size(); ++i)
  {
    this->Cells[rest[i]] = cells[i];
    if (!cells[i].IsWaiting())
    {
      this->Stack.push_back(rest[i]);
    }
  }
  this->SortOn();
}

//------------------------------------------------------------------------------
void TwoEndedSort::SortOn()
{
  const int* end = TopologicalSort::Run(this->Cells, this->LongLists, this->Stack,
    this->NumberOfMeshCells, this->Order.data() + this->NumberOrdered, 1);
  this->NumberOrdered = static_cast<int>(end - this->Order.data());
}

//------------------------------------------------------------------------------
void TwoEndedSort::Release(const std::vector<int>& circle)
{
  for (const int cell : circle)
  {
    this->Cells[cell].State() %= WaitingCell::Unit;
  }
  for (const int cell : circle)
  {
    for (int link = this->Links->Begin(cell); link < this->Links->End(cell); ++link)
    {
      const int neighbor = this->Links->GetNeighbor(link);
      if (this->Links->CompareAcross(link) > 0 && this->IsWaiting(neighbor))
      {
        this->Cells[neighbor].State() -= WaitingCell::Unit;
        if (!this->IsWaiting(neighbor))
        {
          this->Stack.push_back(neighbor);
        }
      }
    }
  }
  this->SortOn();
}
