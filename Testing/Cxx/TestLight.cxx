// Lit tetrahedra and gradient opacity against the oracle: outside, inside and along an axis, smooth
// and spiky transfer functions, every kind of light, soft and hard highlights.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkLight.h"
#include "vtkPointData.h"

#include <functional>

namespace
{
const double Views[3][3] = { { 0.5, 0.8, 2.2 }, { 0.1, -0.05, 0.2 }, { -2.0, 0.0, 0.0 } };

class LitScene : public TestScene
{
public:
  LitScene()
    : TestScene(64, 64)
  {
    auto grid = TestMeshes::Delaunay(200);
    TestMeshes::SetField(grid, TestMeshes::Waves);
    this->SetGrid(grid);
    this->Property->ShadeOn();
    this->Property->SetAmbient(0.1);
    this->Property->SetDiffuse(0.7);
    this->Property->SetSpecular(0.4);
    this->Property->SetSpecularPower(10.0);
  }

  vtkLight* AddLight(double x, double y, double z)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(x, y, z);
    light->SetFocalPoint(0.0, 0.1, 0.0);
    this->Renderer->AddLight(light);
    return light;
  }
};

void CheckScene(TestChecks& checks, TestScene& scene, const std::string& name, int views = 3)
{
  for (int view = 0; view < views; ++view)
  {
    scene.LookFrom(Views[view][0], Views[view][1], Views[view][2]);
    const double error = scene.MaximumError(name);
    checks.Check(error >= 0.0 && error <= 1e-3, name.c_str(), __LINE__, std::to_string(error));
  }
}

void CheckFunctions(TestChecks& checks)
{
  LitScene scene;
  CheckScene(checks, scene, "smooth");
  scene.Property->SetSpecularPower(1.0);
  CheckScene(checks, scene, "power 1", 1);
  scene.SetSpiky();
  scene.Property->SetSpecularPower(80.0);
  CheckScene(checks, scene, "spiky, power 80", 1);
  scene.Property->SetSpecularPower(10.0);
  CheckScene(checks, scene, "spiky");
  // Optically thick, scaled and turned, with clipping planes' limits inside cells.
  scene.Property->SetScalarOpacityUnitDistance(0.02);
  scene.Volume->SetScale(1.0, 0.4, 1.3);
  scene.Volume->RotateZ(30.0);
  CheckScene(checks, scene, "opaque, scaled");
}

void CheckLights(TestChecks& checks)
{
  LitScene scene;
  vtkLight* first = scene.AddLight(1.0, 2.0, -1.0);
  first->SetColor(1.0, 0.6, 0.3);
  CheckScene(checks, scene, "scene light", 1);
  vtkLight* second = scene.AddLight(0.4, 0.9, 0.7);
  second->PositionalOn();
  second->SetConeAngle(100.0);
  second->SetAttenuationValues(0.2, 0.5, 1.5);
  second->SetIntensity(0.8);
  second->SetAmbientColor(0.1, 0.2, 0.3);
  second->SetSpecularColor(0.0, 1.0, 0.0);
  CheckScene(checks, scene, "and a point");
  vtkLight* camera = scene.AddLight(1.0, 1.0, 0.0);
  camera->SetLightTypeToCameraLight();
  scene.AddLight(3.0, 1.0, 0.0)->SwitchOff();
  CheckScene(checks, scene, "and a camera light, one off", 2);
  scene.LookFrom(Views[0][0], Views[0][1], Views[0][2]);
  scene.Render();
  auto without = scene.CopyCaptured();
  second->SetConeAngle(35.0);
  second->SetExponent(4.0);
  CheckScene(checks, scene, "spot", 1);
  CHECK(TestScene::Difference(without, scene.Mapper->GetCapturedImage()) > 0.02);
}

void CheckGradientOpacity(TestChecks& checks)
{
  LitScene scene;
  scene.Property->ShadeOff();
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.2, 0.0);
  function->AddPoint(1.0, 1.0);
  function->AddPoint(1.5, 0.3);
  function->AddPoint(1.5, 0.9);
  scene.Property->SetGradientOpacity(function);
  CheckScene(checks, scene, "gradient opacity");
  scene.Property->ShadeOn();
  scene.SetSpiky();
  scene.Volume->SetScale(1.0, 0.5, 1.2);
  CheckScene(checks, scene, "gradient opacity, spiky, lit", 2);
  auto with = scene.CopyCaptured();
  scene.Property->DisableGradientOpacityOn();
  CheckScene(checks, scene, "gradient opacity disabled", 2);
  CHECK(TestScene::Difference(with, scene.Mapper->GetCapturedImage()) > 0.05);
}

// No gradient, no direction: ambient alone.
void CheckNoGradient(TestChecks& checks)
{
  LitScene scene;
  const std::function<double(const double*)> constant = [](const double*) { return 0.5; };
  auto* grid = vtkUnstructuredGrid::SafeDownCast(scene.Mapper->GetInput());
  TestMeshes::SetField(grid, constant);
  CheckScene(checks, scene, "constant scalars", 1);
  const auto pixel = scene.CenterPixel();
  scene.Property->ShadeOff();
  scene.Render();
  CHECK_NEAR(pixel[0], 0.1 * scene.CenterPixel()[0], 1e-6);
  CHECK(pixel[0] > 0.01);
  scene.Property->ShadeOn();
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    values->InsertNextValue(cell % 7 / 7.0);
  }
  values->SetName("cells");
  grid->GetCellData()->SetScalars(values);
  scene.Mapper->SetScalarModeToUseCellData();
  scene.Oracle->SetCellScalars(true);
  CheckScene(checks, scene, "cell scalars", 1);
}
}

int TestLight(int, char*[])
{
  TestChecks checks;
  CheckFunctions(checks);
  CheckLights(checks);
  CheckGradientOpacity(checks);
  CheckNoGradient(checks);
  return checks.Result();
}
