#include "TetrahedraSelection.h"

#include "ScalarField.h"
#include "TransferFunction.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

//------------------------------------------------------------------------------
void TetrahedraSelection::TakeCorners(vtkUnstructuredGrid* tetrahedra)
{
  const vtkIdType cells = tetrahedra->GetNumberOfCells();
  this->Corners.resize(4 * static_cast<size_t>(cells));
  vtkSMPTools::For(0, cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        tetrahedra->GetCellPoints(cell, ids);
        int* corners = &this->Corners[4 * cell];
        std::transform(ids->begin(), ids->begin() + 4, corners,
          [](vtkIdType id) { return static_cast<int>(id); });
        std::sort(corners, corners + 4);
      }
    });
}

//------------------------------------------------------------------------------
TetrahedraSelection::Class TetrahedraSelection::ClassOf(
  vtkIdType cell, const ScalarField& scalars, const Emptiness& isEmpty) const
{
  float range[2];
  if (!scalars.FindCellRange(cell, &this->Corners[4 * cell], 4, range))
  {
    return Invalid;
  }
  return isEmpty(range[0], range[1]) ? Transparent : Drawn;
}

//------------------------------------------------------------------------------
void TetrahedraSelection::Classify(const ScalarField& scalars, const TransferFunction& function)
{
  this->Classify(scalars,
    [&function](float low, float high) { return function.IsTransparent(low, high); });
}

//------------------------------------------------------------------------------
void TetrahedraSelection::Classify(const ScalarField& scalars, const Emptiness& isEmpty)
{
  const vtkIdType cells = this->GetNumberOfCells();
  this->Classes.resize(static_cast<size_t>(cells));
  vtkSMPTools::For(0, cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        this->Classes[cell] = this->ClassOf(cell, scalars, isEmpty);
      }
    });
  this->NumberOfTransparentCells =
    std::count(this->Classes.begin(), this->Classes.end(), Transparent);
  this->NumberOfInvalidCells = std::count(this->Classes.begin(), this->Classes.end(), Invalid);
}

//------------------------------------------------------------------------------
void TetrahedraSelection::TakeAll()
{
  this->Classes.assign(static_cast<size_t>(this->GetNumberOfCells()), Drawn);
  this->NumberOfTransparentCells = this->NumberOfInvalidCells = 0;
}
