#include "TwoEndedSort.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
constexpr vtkIdType BlockSize = 8192;
}

//------------------------------------------------------------------------------
void TwoEndedSort::Build(const SignedLinks& links, const std::vector<double>& centers,
  const double center[3], const std::vector<int>& inputIds, int numberOfMeshCells)
{
  this->InputIds = &inputIds;
  this->Links = &links;
  this->Centers = &centers;
  std::copy_n(center, 3, this->Center);
  this->NumberOfMeshCells = numberOfMeshCells;
  this->Cells.resize(static_cast<size_t>(links.GetNumberOfCells()));
  this->LongLists.resize(static_cast<size_t>(links.GetNumberOfLinks()));
  this->Stack.Cells.resize(this->Cells.size() + 1);
  this->NearStack.Cells.resize(this->Cells.size() + 1);
  this->Blocks.resize((this->Cells.size() + BlockSize - 1) / BlockSize);
  this->Sight.Build(links, centers);
}

//------------------------------------------------------------------------------
// By blocks that do not depend on the threads: what they hold is then in the order of the cells.
template <class Work>
void TwoEndedSort::ForEachBlock(Work work)
{
  const auto cells = static_cast<vtkIdType>(this->Cells.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Blocks.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        this->Blocks[block].Far.clear();
        this->Blocks[block].Near.clear();
        work(static_cast<int>(block * BlockSize),
          static_cast<int>(std::min(cells, (block + 1) * BlockSize)), this->Blocks[block]);
      }
    });
}

//------------------------------------------------------------------------------
void TwoEndedSort::ChooseHalves(const double eye[4])
{
  double towards[3];
  for (int i = 0; i < 3; ++i)
  {
    towards[i] = eye[i] - eye[3] * this->Center[i];
  }
  this->Halves = this->Sight.Find(towards, this->FarSide);
}

//------------------------------------------------------------------------------
// From the first links of each cell, which are all that a tetrahedron has. Nothing is called in the
// loop and nothing in it is to guess: this is much of the time that a frame takes.
void TwoEndedSort::FindFewNext(int begin, int end)
{
  const SignedLinks& links = *this->Links;
  for (int cell = begin; cell < end; ++cell)
  {
    const int first = links.Begin(cell);
    const int reversed = this->IsFar(cell) ? 0 : 1;
    const int listed = this->Halves[cell];
    WaitingCell& own = this->Cells[cell];
    int count = 0;
    int before = 0;
    for (int i = 0; i < SignedLinks::FewLinks; ++i)
    {
      const int across = links.CompareAcross(first + i, reversed);
      before += across < 0 ? 1 : 0;
      // Written in any case, kept where it counts.
      own.Next[count] = links.GetNeighbor(first + i);
      count += (across > 0 ? 1 : 0) & listed >> i;
    }
    own.State() = before * WaitingCell::Unit + count;
  }
}

//------------------------------------------------------------------------------
template <class Predicate>
WaitingCell TwoEndedSort::FindNext(int cell, int reversed, Predicate isListed, bool countsAll)
{
  const int first = this->Links->Begin(cell);
  const int last = this->Links->End(cell);
  int* list = &this->LongLists[first];
  int next = 0;
  int before = 0;
  for (int link = first; link < last; ++link)
  {
    const int across = this->Links->CompareAcross(link, reversed);
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
// Of the cells that have more links, or release as many as all four.
void TwoEndedSort::FindManyNext(int begin, int end)
{
  for (int cell = begin; cell < end; ++cell)
  {
    if (this->Links->End(cell) - this->Links->Begin(cell) > SignedLinks::FewLinks ||
      this->Cells[cell].State() % WaitingCell::Unit == WaitingCell::LongList)
    {
      const bool far = this->IsFar(cell);
      this->Cells[cell] = this->FindNext(
        cell, far ? 0 : 1, [&](int neighbor) { return this->IsFar(neighbor) == far; }, true);
    }
  }
}

//------------------------------------------------------------------------------
void TwoEndedSort::FindNext()
{
  this->ForEachBlock(
    [this](int begin, int end, Block& block)
    {
      this->FindFewNext(begin, end);
      this->FindManyNext(begin, end);
      for (int cell = begin; cell < end; ++cell)
      {
        if (!this->IsWaiting(cell))
        {
          (this->IsFar(cell) ? block.Far : block.Near).push_back(cell);
        }
      }
    });
}

//------------------------------------------------------------------------------
double TwoEndedSort::GetDistance(int cell, const double eye[4]) const
{
  const double* center = &(*this->Centers)[3 * static_cast<size_t>(cell)];
  return eye[3] == 0.0 ? -vtkMath::Dot(center, eye) : vtkMath::Distance2BetweenPoints(center, eye);
}

//------------------------------------------------------------------------------
// The stack's end is taken first: by `farthest` that is the farthest cell, else the nearest.
void TwoEndedSort::SortByCenters(CellStack& stack, bool farthest, const double eye[4]) const
{
  std::vector<std::pair<double, int>> cells(static_cast<size_t>(stack.Size));
  for (int i = 0; i < stack.Size; ++i)
  {
    const double distance = this->GetDistance(stack.Cells[i], eye);
    cells[i] = { farthest ? distance : -distance, stack.Cells[i] };
  }
  std::sort(cells.begin(), cells.end());
  std::transform(cells.begin(), cells.end(), stack.Cells.begin(),
    [](const std::pair<double, int>& cell) { return cell.second; });
}

//------------------------------------------------------------------------------
void TwoEndedSort::SortHalf(bool far, const double eye[4], bool centersFirst)
{
  CellStack& stack = far ? this->Stack : this->NearStack;
  for (const Block& block : this->Blocks)
  {
    const std::vector<int>& sources = far ? block.Far : block.Near;
    std::copy(sources.begin(), sources.end(), stack.Cells.begin() + stack.Size);
    stack.Size += static_cast<int>(sources.size());
  }
  if (centersFirst)
  {
    this->SortByCenters(stack, far, eye);
  }
  vtkIdType* const begin = this->Order.data();
  vtkIdType* const from = far ? begin : begin + this->NumberOfMeshCells - 1;
  vtkIdType* const to = TopologicalSort::Run(this->Cells, this->LongLists, stack,
    { this->InputIds->data(), this->NumberOfMeshCells, from, far ? 1 : -1 });
  (far ? this->NumberOrdered : this->NearBegin) = static_cast<int>(to - begin) + (far ? 0 : 1);
}

//------------------------------------------------------------------------------
void TwoEndedSort::Sort(const double eye[4], bool centersFirst)
{
  this->ChooseHalves(eye);
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
  this->SortRest(eye, centersFirst);
}

//------------------------------------------------------------------------------
void TwoEndedSort::FindRest()
{
  this->ForEachBlock(
    [this](int begin, int end, Block& block)
    {
      for (int cell = begin; cell < end; ++cell)
      {
        if (this->IsWaiting(cell))
        {
          block.Far.push_back(cell);
        }
      }
    });
  this->Rest.clear();
  for (const Block& block : this->Blocks)
  {
    this->Rest.insert(this->Rest.end(), block.Far.begin(), block.Far.end());
  }
}

//------------------------------------------------------------------------------
void TwoEndedSort::SortRest(const double eye[4], bool centersFirst)
{
  this->FindRest();
  this->RestCells.resize(this->Rest.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Rest.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->RestCells[i] = this->FindNext(
          this->Rest[i], 0, [this](int neighbor) { return this->IsWaiting(neighbor); }, false);
      }
    });
  for (size_t i = 0; i < this->Rest.size(); ++i)
  {
    this->Cells[this->Rest[i]] = this->RestCells[i];
    if (!this->RestCells[i].IsWaiting())
    {
      this->Stack.Push(this->Rest[i]);
    }
  }
  if (centersFirst)
  {
    this->SortByCenters(this->Stack, true, eye);
  }
  this->SortOn();
}

//------------------------------------------------------------------------------
void TwoEndedSort::SortOn()
{
  vtkIdType* const next = this->Order.data() + this->NumberOrdered;
  const vtkIdType* end = TopologicalSort::Run(this->Cells, this->LongLists, this->Stack,
    { this->InputIds->data(), this->NumberOfMeshCells, next, 1 });
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
          this->Stack.Push(neighbor);
        }
      }
    }
  }
  this->SortOn();
}
