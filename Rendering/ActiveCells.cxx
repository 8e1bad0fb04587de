#include "ActiveCells.h"

#include "ShellCells.h"
#include "ShellPlan.h"

#include <algorithm>

//------------------------------------------------------------------------------
void ActiveCells::Begin(
  const ShellCells& cells, const ShellPlan& plan, vtkIdType begin, vtkIdType end)
{
  std::vector<int> firstShells;
  std::vector<Entry> seen;
  this->Starts.assign(static_cast<size_t>(plan.NumberOfShells) + 1, 0);
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    if (cells.IsSeen(cell))
    {
      int shells[2];
      plan.FindShells(cells.Nearest[cell], cells.Farthest[cell], shells);
      firstShells.push_back(shells[0]);
      seen.push_back({ cell, shells[1] });
      ++this->Starts[shells[0] + 1];
    }
  }
  for (size_t shell = 1; shell < this->Starts.size(); ++shell)
  {
    this->Starts[shell] += this->Starts[shell - 1];
  }
  std::vector<vtkIdType> next(this->Starts.begin(), this->Starts.end() - 1);
  this->Entries.resize(seen.size());
  for (size_t i = 0; i < seen.size(); ++i)
  {
    this->Entries[next[firstShells[i]]++] = seen[i];
  }
  this->Active.clear();
  this->Cells.clear();
  this->Shell = -1;
}

//------------------------------------------------------------------------------
void ActiveCells::Advance()
{
  ++this->Shell;
  this->Active.erase(std::remove_if(this->Active.begin(), this->Active.end(),
                       [this](const Entry& entry) { return entry.LastShell < this->Shell; }),
    this->Active.end());
  this->Active.insert(this->Active.end(), this->Entries.begin() + this->Starts[this->Shell],
    this->Entries.begin() + this->Starts[this->Shell + 1]);
  this->Cells.resize(this->Active.size());
  std::transform(this->Active.begin(), this->Active.end(), this->Cells.begin(),
    [](const Entry& entry) { return entry.Cell; });
}
