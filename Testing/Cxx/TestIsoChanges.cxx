// Opaque iso-surfaces after a change: other values count other turned cells, lost cells are counted
// once, fewer points after light, an upload that failed before, values that are not numbers, a light
// that takes all lights' places into account; colours by components are named.

#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"

#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <cmath>
#include <limits>

namespace
{
constexpr int Size = 48;

double Height(const double* p)
{
  return p[2];
}

class LayerScene : public TestScene
{
public:
  vtkNew<MessageObserver> Messages;

  explicit LayerScene(vtkUnstructuredGrid* grid)
    : TestScene(vtkNew<vtkBarycentricShellMapper>(), Size, Size)
  {
    this->SetGrid(grid);
    this->Messages->Watch(this->Mapper);
    this->Mapper->SetBlendModeToIsoSurface();
    this->SetConstant(1.0);
    this->Property->GetIsoSurfaceValues()->SetValue(0, 0.23);
  }
  vtkBarycentricShellMapper* GetShells()
  {
    return vtkBarycentricShellMapper::SafeDownCast(this->Mapper);
  }
  int GetStatistic(const char* column)
  {
    return this->Mapper->GetLastStatistics()->GetValueByName(0, column).ToInt();
  }
};

TestMeshes::Grid Layers(int cells)
{
  auto grid = TestMeshes::JitteredCube(cells);
  TestMeshes::SetField(grid, Height);
  return grid;
}

// A point inside the mesh near this height.
vtkIdType FindInside(vtkUnstructuredGrid* grid, double height)
{
  vtkIdType found = 0;
  double least = std::numeric_limits<double>::max();
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    const double* p = grid->GetPoint(id);
    const double distance = std::hypot(p[0], p[1]) + std::abs(p[2] - height);
    found = distance < least ? id : found;
    least = std::min(distance, least);
  }
  return found;
}

void MovePoint(vtkUnstructuredGrid* grid, vtkIdType id, double x)
{
  double p[3];
  grid->GetPoints()->GetPoint(id, p);
  grid->GetPoints()->SetPoint(id, x, p[1], p[2]);
  grid->GetPoints()->Modified();
}

// Cells that turn away from the surface count when another value cuts them, and no longer after.
void CheckTurned(TestChecks& checks)
{
  auto grid = Layers(6);
  LayerScene scene(grid);
  scene.Render();
  MovePoint(grid, FindInside(grid, -0.3), 0.45);
  scene.Render();
  CHECK(scene.GetShells()->GetNumberOfTurnedCells() == 0);
  scene.Property->GetIsoSurfaceValues()->SetValue(0, -0.3);
  scene.Render();
  CHECK(scene.GetShells()->GetNumberOfTurnedCells() > 0);
  CHECK(scene.Messages->CountOf("inside out") == 1);
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 0.23);
  scene.Render();
  CHECK(scene.GetShells()->GetNumberOfTurnedCells() == 0);
  scene.Mapper->SetBlendModeToComposite();
  scene.Render();
  CHECK(scene.GetShells()->GetNumberOfTurnedCells() > 0);
  scene.Mapper->SetBlendModeToIsoSurface();
  scene.Render();
  CHECK(scene.GetShells()->GetNumberOfTurnedCells() == 0);
}

// A cell with a corner nowhere is skipped, whatever its triangles: as where rays find surfaces.
void CheckLost(TestChecks& checks)
{
  auto grid = Layers(6);
  LayerScene scene(grid);
  scene.Render();
  const int cut = scene.GetStatistic("CellsDrawn");
  CHECK(scene.GetStatistic("CellsSkippedInvalid") == 0);
  MovePoint(grid, FindInside(grid, 0.23), std::numeric_limits<double>::quiet_NaN());
  scene.Render();
  const int lost = scene.GetStatistic("CellsSkippedInvalid");
  CHECK(lost > 0);
  CHECK(scene.GetStatistic("CellsDrawn") + lost == cut);
  scene.SetConstant(0.999);
  scene.Render();
  CHECK(scene.GetStatistic("CellsSkippedInvalid") == lost);
}

// Components of colours are not the surface's: named, and no gradient is asked of points that went.
void CheckComponents(TestChecks& checks)
{
  LayerScene scene(Layers(8));
  scene.Property->ShadeOn();
  scene.Render();
  auto few = Layers(2);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(few->GetNumberOfPoints());
  for (vtkIdType id = 0; id < few->GetNumberOfPoints(); ++id)
  {
    colors->SetTuple4(id, few->GetPoint(id)[2] > 0.1 ? 200 : 20, 0, 255, 30);
  }
  few->GetPointData()->SetScalars(colors);
  scene.SetGrid(few);
  scene.Property->IndependentComponentsOff();
  scene.Property->ShadeOff();
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 110.0);
  scene.Render();
  scene.Render();
  CHECK(scene.Messages->CountOf("one component of 4 is drawn") == 1);
  CHECK(scene.CenterPixel()[3] == 1.0);
}

// What is not a number is named, and cuts no cell again in the next frame.
void CheckValues(TestChecks& checks)
{
  LayerScene scene(Layers(3));
  scene.Render();
  auto picture = scene.CopyCaptured();
  scene.Property->GetIsoSurfaceValues()->SetValue(1, std::numeric_limits<double>::quiet_NaN());
  scene.Property->GetIsoSurfaceValues()->SetValue(2, std::numeric_limits<double>::infinity());
  scene.Render();
  scene.Render();
  CHECK(scene.GetShells()->GetUploadedBytes() == 0);
  CHECK(scene.Messages->Count() == 1 && scene.Messages->CountOf("not finite") == 1);
  CHECK(TestScene::Difference(picture, scene.Mapper->GetCapturedImage()) == 0.0);
}

vtkSmartPointer<vtkLight> AddLight(TestScene& scene, double x, double red)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(x, 1.0, 2.0);
  light->SetColor(red, 0.5, 0.3);
  scene.Renderer->AddLight(light);
  return light;
}

// One light of no intensity at a place of its own: the image is that of lights far away.
void CheckLights(TestChecks& checks)
{
  auto grid = TestMeshes::JitteredCube(6);
  TestMeshes::SetField(grid, [](const double* p) { return p[0] * p[0] + p[1] * p[1] + p[2]; });
  LayerScene scene(grid);
  scene.Property->ShadeOn();
  scene.Property->SetSpecular(0.5);
  scene.Property->SetSpecularPower(7.5);
  scene.Renderer->AutomaticLightCreationOff();
  scene.Renderer->RemoveAllLights();
  for (const double opacity : { 1.0, 0.5 })
  {
    scene.SetConstant(opacity);
    scene.Renderer->RemoveAllLights();
    scene.Render();
    auto dark = scene.CopyCaptured();
    AddLight(scene, 0.5, 0.9);
    AddLight(scene, -1.0, 0.2);
    scene.Render();
    auto distant = scene.CopyCaptured();
    CHECK(TestScene::Difference(dark, distant) > 0.1);
    auto placed = AddLight(scene, 0.0, 1.0);
    placed->PositionalOn();
    placed->SetIntensity(0.0);
    scene.Render();
    CHECK_AT_MOST(TestScene::Difference(distant, scene.Mapper->GetCapturedImage()), 1e-5);
    placed->SetIntensity(0.5);
    scene.Render();
    CHECK(TestScene::Difference(distant, scene.Mapper->GetCapturedImage()) > 0.01);
  }
}

// Triangles have uploads of their own: neither the failure nor the time is that of an earlier frame.
void CheckUploads(TestChecks& checks)
{
  auto grid = Layers(3);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(grid->GetNumberOfPoints());
  coordinates->Fill(0.5);
  grid->GetPointData()->SetTCoords(coordinates);
  LayerScene scene(grid);
  scene.Render();
  CHECK(scene.GetShells()->GetUploadSeconds() > 0.0);
  scene.Render();
  CHECK(scene.GetShells()->GetUploadedBytes() == 0);
  vtkNew<vtkImageData> image;
  image->SetDimensions(1 << 20, 1, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(0.0);
  scene.Mapper->SetBlendModeToComposite();
  scene.GetShells()->SetVolumeTexture(image);
  scene.Render();
  CHECK(scene.Messages->Count() == 1 && scene.Messages->CountOf("no room for a texture") == 1);
  scene.GetShells()->SetVolumeTexture(nullptr);
  scene.Mapper->SetBlendModeToIsoSurface();
  scene.Render();
  CHECK(scene.CenterPixel()[3] == 1.0);
  CHECK(scene.Messages->Count() == 1);
}
}

int TestIsoChanges(int, char*[])
{
  TestChecks checks;
  CheckTurned(checks);
  CheckLost(checks);
  CheckComponents(checks);
  CheckValues(checks);
  CheckUploads(checks);
  CheckLights(checks);
  return checks.Result();
}
