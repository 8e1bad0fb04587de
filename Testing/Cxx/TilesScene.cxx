#include "TilesScene.h"

#include "VolumePropertyReader.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <chrono>
#include <iostream>

namespace
{
glm::dmat4 ToGLM(vtkMatrix4x4* matrix)
{
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}
}

//------------------------------------------------------------------------------
TilesScene::TilesScene(int width, int height)
  : TestScene(width, height)
  , Size{ width, height }
{
}

//------------------------------------------------------------------------------
void TilesScene::SetTetrahedra(vtkUnstructuredGrid* grid, bool cellScalars)
{
  this->Grid = grid;
  this->CellScalars = cellScalars;
  this->Oracle->SetInputData(grid);
  this->Oracle->SetCellScalars(cellScalars);
  this->Coordinates.Build(grid);
  this->Selection.TakeCorners(grid);
  this->Engine.SetMesh(this->Coordinates.Points, this->Selection.Corners);
}

//------------------------------------------------------------------------------
void TilesScene::LookAt(
  vtkUnstructuredGrid* grid, const double (&direction)[3], double distance)
{
  double bounds[6], center[3];
  grid->GetBounds(bounds);
  grid->GetCenter(center);
  const double away = distance * grid->GetLength();
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] + away * direction[0], center[1] + away * direction[1],
    center[2] + away * direction[2]);
  this->Renderer->ResetCameraClippingRange(bounds);
}

//------------------------------------------------------------------------------
TilesEngine::Scene TilesScene::DescribeScene()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double aspect = static_cast<double>(this->Size[0]) / this->Size[1];
  const glm::dmat4 worldToView = ToGLM(camera->GetModelViewTransformMatrix());
  const glm::dmat4 meshToData =
    glm::scale(glm::translate(glm::dmat4(1.0), glm::make_vec3(this->Coordinates.Center.data())),
      glm::dvec3(this->Coordinates.Scale));
  this->Volume->ComputeMatrix();
  TilesEngine::Scene scene;
  scene.Camera.MeshToView = worldToView * ToGLM(this->Volume->GetMatrix()) * meshToData;
  scene.Camera.ViewToClip = ToGLM(camera->GetProjectionTransformMatrix(aspect, -1, 1));
  scene.Camera.ViewToWorld = glm::inverse(worldToView);
  scene.Camera.Width = this->Size[0];
  scene.Camera.Height = this->Size[1];
  scene.Function = &this->Function;
  scene.OpaqueDepth = this->OpaqueDepth.empty() ? nullptr : this->OpaqueDepth.data();
  scene.BackToFront = this->BackToFront.empty() ? nullptr : &this->BackToFront;
  scene.IsAborted = this->IsAborted;
  scene.EndsEarly = this->EndsEarly;
  scene.TimesStages = this->TimesStages;
  scene.TrustsOrder = this->TrustsOrder;
  vtkPlaneCollection* planes = this->Mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    const glm::dvec3 normal = glm::make_vec3(planes->GetItem(i)->GetNormal());
    const double offset = -glm::dot(normal, glm::make_vec3(planes->GetItem(i)->GetOrigin()));
    scene.ClippingPlanes.emplace_back(glm::dvec4(normal, offset) * scene.Camera.ViewToWorld);
  }
  return scene;
}

//------------------------------------------------------------------------------
bool TilesScene::DrawTiles()
{
  VolumePropertyReader reader(this->Property);
  vtkDataArray* scalars = this->CellScalars ? this->Grid->GetCellData()->GetScalars()
                                            : this->Grid->GetPointData()->GetScalars();
  this->Field.Build(scalars, 0, this->CellScalars, reader.FindLimits().data());
  std::vector<std::string> problems;
  reader.Read(
    this->Field.Normal, this->Field.Range, this->CellScalars, true, this->Function, problems);
  this->Selection.Classify(this->Field, this->Function);
  std::vector<unsigned char> drawn(static_cast<size_t>(this->Grid->GetNumberOfCells()));
  for (size_t cell = 0; cell < drawn.size(); ++cell)
  {
    drawn[cell] = this->Selection.IsDrawn(static_cast<vtkIdType>(cell)) ? 1 : 0;
  }
  this->Engine.SetScalars(this->Field.Values, this->CellScalars);
  this->Engine.SetDrawn(drawn);
  const TilesEngine::Scene scene = this->DescribeScene();
  const auto start = std::chrono::steady_clock::now();
  const bool isDrawn = this->Engine.Render(scene);
  this->SecondsOfEngine = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return isDrawn;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> TilesScene::CopyTiles() const
{
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfComponents(4);
  values->SetNumberOfTuples(static_cast<vtkIdType>(this->Engine.GetImage().size() / 4));
  std::copy(this->Engine.GetImage().begin(), this->Engine.GetImage().end(), values->GetPointer(0));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(this->Size[0], this->Size[1], 1);
  image->GetPointData()->SetScalars(values);
  return image;
}

//------------------------------------------------------------------------------
double TilesScene::TilesError(const std::string& name)
{
  this->Oracle->SetVolume(this->Volume);
  this->Oracle->SetCamera(this->Renderer->GetActiveCamera());
  this->Oracle->SetSize(this->Size[0], this->Size[1]);
  this->Oracle->SetClippingPlanes(this->Mapper->GetClippingPlanes());
  if (!this->DrawTiles() || !this->Oracle->Update())
  {
    return -1.0;
  }
  auto image = this->CopyTiles();
  this->Oracle->Compare(image);
  int worst[2];
  this->Oracle->GetMaximumErrorPixel(worst);
  std::cout << name << ": covered " << this->Oracle->GetNumberOfCoveredPixels() << " RMSE "
            << this->Oracle->GetRootMeanSquareError() << " maximum "
            << this->Oracle->GetMaximumError() << " at " << worst[0] << " " << worst[1]
            << ", repaired " << this->Engine.GetCounts().RepairedPixels << "\n";
  return this->Oracle->GetNumberOfCoveredPixels() > 0 ? this->Oracle->GetMaximumError() : -1.0;
}
