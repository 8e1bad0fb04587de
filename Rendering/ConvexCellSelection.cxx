#include "ConvexCellSelection.h"

#include "ScalarField.h"
#include "vtkSMPTools.h"

#include <algorithm>

//------------------------------------------------------------------------------
void ConvexCellSelection::Classify(
  const ConvexCellFaces::Rows& corners, const ScalarField& scalars, const Emptiness& isEmpty)
{
  const int cells = corners.GetNumberOfRows();
  this->Classes.resize(static_cast<size_t>(cells));
  vtkSMPTools::For(0, cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cell = static_cast<int>(begin); cell < end; ++cell)
      {
        float range[2];
        const bool finite =
          scalars.FindCellRange(cell, corners.GetRow(cell), corners.GetSize(cell), range);
        this->Classes[cell] = !finite ? Invalid : isEmpty(range[0], range[1]) ? Transparent : Drawn;
      }
    });
  this->NumberOfTransparentCells =
    std::count(this->Classes.begin(), this->Classes.end(), Transparent);
  this->NumberOfInvalidCells = std::count(this->Classes.begin(), this->Classes.end(), Invalid);
  this->DrawnCells.clear();
  for (int cell = 0; cell < cells; ++cell)
  {
    if (this->IsDrawn(cell))
    {
      this->DrawnCells.push_back(static_cast<unsigned int>(cell));
    }
  }
}
