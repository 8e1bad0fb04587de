#include "FaceOrderSort.h"

#include "vtkCamera.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(FaceOrderSort);

//------------------------------------------------------------------------------
void FaceOrderSort::FindSharedFaces()
{
  std::map<std::array<vtkIdType, 3>, vtkIdType> open;
  vtkNew<vtkIdList> ids;
  this->Faces.clear();
  for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
  {
    this->Input->GetCellPoints(cell, ids);
    for (int left = 0; left < 4; ++left)
    {
      std::array<vtkIdType, 3> key{};
      for (int i = 0, n = 0; i < 4; ++i)
      {
        if (i != left)
        {
          key[n++] = ids->GetId(i);
        }
      }
      std::sort(key.begin(), key.end());
      const auto found = open.find(key);
      if (found == open.end())
      {
        open.emplace(key, cell);
        continue;
      }
      this->Faces.push_back({ { key[0], key[1], key[2] }, { found->second, cell } });
      open.erase(found);
    }
  }
}

//------------------------------------------------------------------------------
double FaceOrderSort::SideOf(const Face& face, const double point[3], double w)
{
  double corner[3][3], a[3], b[3], toPoint[3];
  for (int i = 0; i < 3; ++i)
  {
    this->Input->GetPoint(face.Points[i], corner[i]);
  }
  vtkMath::Subtract(corner[1], corner[0], a);
  vtkMath::Subtract(corner[2], corner[0], b);
  for (int i = 0; i < 3; ++i)
  {
    toPoint[i] = point[i] - w * corner[0][i];
  }
  double normal[3];
  vtkMath::Cross(a, b, normal);
  return vtkMath::Dot(normal, toPoint);
}

//------------------------------------------------------------------------------
bool FaceOrderSort::FindNearer(const Face& face, vtkIdType& nearer, vtkIdType& farther)
{
  double corner[3], center[3] = { 0.0, 0.0, 0.0 };
  vtkNew<vtkIdList> ids;
  this->Input->GetCellPoints(face.Cells[0], ids);
  for (int i = 0; i < 4; ++i)
  {
    this->Input->GetPoint(ids->GetId(i), corner);
    for (int j = 0; j < 3; ++j)
    {
      center[j] += 0.25 * corner[j];
    }
  }
  const double eyeSide = this->SideOf(face, this->Eye, this->Eye[3]);
  const double cellSide = this->SideOf(face, center, 1.0);
  // Seen edge-on: either order draws the same image.
  if (eyeSide == 0.0 || cellSide == 0.0)
  {
    return false;
  }
  const bool firstIsNearer = (eyeSide > 0.0) == (cellSide > 0.0);
  nearer = face.Cells[firstIsNearer ? 0 : 1];
  farther = face.Cells[firstIsNearer ? 1 : 0];
  return true;
}

//------------------------------------------------------------------------------
void FaceOrderSort::InitTraversal()
{
  double position[4] = { 0.0, 0.0, 0.0, 1.0 };
  this->Camera->GetPosition(position);
  if (this->Camera->GetParallelProjection())
  {
    this->Camera->GetViewPlaneNormal(position);
    position[3] = 0.0;
  }
  this->InverseModelTransform->MultiplyPoint(position, this->Eye);
  this->FindSharedFaces();
  this->SortTopologically();
  this->Returned = false;
}

//------------------------------------------------------------------------------
void FaceOrderSort::SortTopologically()
{
  const vtkIdType cells = this->Input->GetNumberOfCells();
  std::vector<std::vector<vtkIdType>> before(cells);
  std::vector<int> waiting(cells, 0);
  for (const Face& face : this->Faces)
  {
    vtkIdType nearer = 0, farther = 0;
    if (this->FindNearer(face, nearer, farther))
    {
      before[farther].push_back(nearer);
      ++waiting[nearer];
    }
  }
  this->Order->Reset();
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    if (waiting[cell] == 0)
    {
      this->Order->InsertNextValue(cell);
    }
  }
  // The order itself is the queue: what is read releases what is appended.
  for (vtkIdType next = 0; next < this->Order->GetNumberOfTuples(); ++next)
  {
    for (const vtkIdType nearer : before[this->Order->GetValue(next)])
    {
      if (--waiting[nearer] == 0)
      {
        this->Order->InsertNextValue(nearer);
      }
    }
  }
  this->NumberOfUnorderedCells = cells - this->Order->GetNumberOfTuples();
}

//------------------------------------------------------------------------------
vtkIdTypeArray* FaceOrderSort::GetNextCells()
{
  vtkIdTypeArray* batch = this->Returned ? nullptr : this->Order.GetPointer();
  this->Returned = true;
  return batch;
}
