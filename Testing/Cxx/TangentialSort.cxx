#include "TangentialSort.h"

#include "vtkCamera.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkTetra.h"

#include <algorithm>
#include <utility>
#include <vector>

vtkStandardNewMacro(TangentialSort);

//------------------------------------------------------------------------------
void TangentialSort::InitTraversal()
{
  double position[4] = { 0.0, 0.0, 0.0, 1.0 };
  double eye[4];
  this->Camera->GetPosition(position);
  this->InverseModelTransform->MultiplyPoint(position, eye);

  std::vector<std::pair<double, vtkIdType>> keys;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
  {
    this->Input->GetCellPoints(cell, ids);
    double corner[4][3], center[3];
    for (int i = 0; i < 4; ++i)
    {
      this->Input->GetPoint(ids->GetId(i), corner[i]);
    }
    const double squaredRadius =
      vtkTetra::Circumsphere(corner[0], corner[1], corner[2], corner[3], center);
    keys.emplace_back(vtkMath::Distance2BetweenPoints(center, eye) - squaredRadius, cell);
  }
  std::sort(keys.rbegin(), keys.rend());
  this->Order->Reset();
  for (const auto& key : keys)
  {
    this->Order->InsertNextValue(key.second);
  }
  this->Returned = false;
}

//------------------------------------------------------------------------------
vtkIdTypeArray* TangentialSort::GetNextCells()
{
  vtkIdTypeArray* batch = this->Returned ? nullptr : this->Order.GetPointer();
  this->Returned = true;
  return batch;
}
