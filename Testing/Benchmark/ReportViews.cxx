#include "ReportViews.h"

#include "BenchmarkScene.h"

#include "vtkCamera.h"
#include "vtkCellProjectionOracle.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>

namespace
{
// From the middle, in lengths of the bounds' diagonal; nothing is seen along an axis of the mesh.
const double Outside[2][3] = { { 1.22, -1.2, 1.03 }, { -1.37, 0.83, 1.21 } };
const double InsideDirection[3] = { 0.71, 0.53, -0.37 };

void FindMiddle(vtkUnstructuredGrid* tetrahedra, vtkIdType cell, double middle[3])
{
  vtkNew<vtkIdList> corners;
  tetrahedra->GetCellPoints(cell, corners);
  std::fill_n(middle, 3, 0.0);
  for (const vtkIdType id : *corners)
  {
    vtkMath::Add(middle, tetrahedra->GetPoint(id), middle);
  }
  vtkMath::MultiplyScalar(middle, 1.0 / static_cast<double>(corners->GetNumberOfIds()));
}
}

//------------------------------------------------------------------------------
ReportViews::ReportViews(vtkUnstructuredGrid* tetrahedra, int size)
  : Size(size)
  , Length(tetrahedra->GetLength())
{
  tetrahedra->GetCenter(this->Center);
  double nearest = std::numeric_limits<double>::infinity();
  for (vtkIdType cell = 0; cell < tetrahedra->GetNumberOfCells(); ++cell)
  {
    double middle[3];
    FindMiddle(tetrahedra, cell, middle);
    const double distance = vtkMath::Distance2BetweenPoints(middle, this->Center);
    if (distance < nearest)
    {
      nearest = distance;
      std::copy_n(middle, 3, this->Within);
    }
  }
}

//------------------------------------------------------------------------------
void ReportViews::Look(int view, vtkRenderer* renderer) const
{
  const bool isInside = view == Inside;
  double eye[3], focus[3];
  for (int i = 0; i < 3; ++i)
  {
    eye[i] = isInside ? this->Within[i] : this->Center[i] + this->Length * Outside[view][i];
    focus[i] = isInside ? this->Within[i] + this->Length * InsideDirection[i] : this->Center[i];
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(eye);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(isInside ? 60.0 : 30.0);
  camera->SetClippingRange((isInside ? 1e-3 : 1.0) * this->Length, 3.0 * this->Length);
}

//------------------------------------------------------------------------------
vtkCellProjectionOracle* ReportViews::GetOracle(
  int view, int blendMode, vtkUnstructuredGrid* cells, BenchmarkScene& scene)
{
  vtkSmartPointer<vtkCellProjectionOracle>& oracle = this->Images[{ view, blendMode, cells }];
  if (!oracle)
  {
    oracle = vtkSmartPointer<vtkCellProjectionOracle>::New();
    oracle->SetInputData(cells);
    oracle->SetVolume(scene.Volume);
    oracle->SetCamera(scene.Renderer->GetActiveCamera());
    oracle->SetSize(this->Size, this->Size);
    oracle->SetBlendMode(blendMode);
    oracle->Update();
  }
  return oracle;
}
