#include "ElementLists.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
// Enough for the threads of a large machine, few enough to be joined at once.
constexpr vtkIdType NumberOfParts = 32;
}

//------------------------------------------------------------------------------
void ElementLists::Begin(const ShellCells& cells, const ShellPlan& plan, vtkIdType begin,
  vtkIdType end, const int* corners)
{
  this->Corners = corners;
  this->FirstCell = begin;
  this->Parts.resize(NumberOfParts);
  vtkSMPTools::For(0, NumberOfParts, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType part = first; part < last; ++part)
      {
        this->Parts[part].Begin(cells, plan, begin + (end - begin) * part / NumberOfParts,
          begin + (end - begin) * (part + 1) / NumberOfParts);
      }
    });
}

//------------------------------------------------------------------------------
void ElementLists::Write(const ActiveCells& part, int* vertex) const
{
  for (const vtkIdType cell : part.Cells)
  {
    vertex = std::copy_n(this->Corners + 4 * (cell - this->FirstCell), 4, vertex);
    *vertex++ = static_cast<int>(cell - this->FirstCell);
  }
}

//------------------------------------------------------------------------------
void ElementLists::Advance()
{
  vtkSMPTools::For(0, NumberOfParts, 1,
    [this](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType part = first; part < last; ++part)
      {
        this->Parts[part].Advance();
      }
    });
  std::vector<size_t> starts(NumberOfParts + 1, 0);
  for (size_t part = 0; part < NumberOfParts; ++part)
  {
    starts[part + 1] = starts[part] + IntegersPerVertex * this->Parts[part].Cells.size();
  }
  this->Vertices.resize(starts.back());
  vtkSMPTools::For(0, NumberOfParts, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType part = first; part < last; ++part)
      {
        this->Write(this->Parts[part], this->Vertices.data() + starts[part]);
      }
    });
}
