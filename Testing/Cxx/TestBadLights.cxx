// Lights that cannot shine, and places with no gradient to be lit by: against the oracle.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkLight.h"

#include <algorithm>

namespace
{
class LitScene : public TestScene
{
public:
  LitScene()
    : TestScene(48, 48)
  {
    this->Grid = TestMeshes::Delaunay(120);
    TestMeshes::SetField(this->Grid, TestMeshes::Waves);
    this->SetGrid(this->Grid);
    this->Property->ShadeOn();
    this->Property->SetSpecular(0.5);
    this->AddLight(1.0, 2.0, -1.0);
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

  TestMeshes::Grid Grid;
};

void CheckError(TestChecks& checks, TestScene& scene, const std::string& name)
{
  const double error = scene.MaximumError(name);
  checks.Check(error >= 0.0 && error <= 1e-3, name.c_str(), __LINE__, std::to_string(error));
}

// No direction, a cone with no axis, attenuation by nothing: as if they were not there.
void CheckDarkLights(TestChecks& checks)
{
  LitScene scene;
  CheckError(checks, scene, "one light");
  const auto alone = scene.CopyCaptured();
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  vtkLight* directional = scene.AddLight(0.3, 0.2, 0.1);
  directional->SetFocalPoint(directional->GetPosition());
  vtkLight* spot = scene.AddLight(0.3, 0.9, 0.1);
  spot->PositionalOn();
  spot->SetConeAngle(30.0);
  spot->SetFocalPoint(spot->GetPosition());
  vtkLight* fading = scene.AddLight(0.3, 0.9, 0.1);
  fading->PositionalOn();
  fading->SetConeAngle(100.0);
  fading->SetAttenuationValues(0.0, 0.0, 0.0);
  scene.Render();
  scene.Render();
  CHECK(TestScene::Difference(alone, scene.Mapper->GetCapturedImage()) == 0.0);
  CHECK(messages->Count() == 1 && messages->CountOf("3 lights have no direction") == 1);
  // A point light needs no direction.
  fading->SetAttenuationValues(1.0, 0.0, 0.0);
  fading->SetFocalPoint(fading->GetPosition());
  scene.Renderer->RemoveLight(spot);
  CheckError(checks, scene, "a point light with no direction");
  CHECK(TestScene::Difference(alone, scene.Mapper->GetCapturedImage()) > 0.05);
  // No light at all is black, and as opaque as before.
  scene.Renderer->RemoveAllLights();
  scene.Renderer->AutomaticLightCreationOff();
  CheckError(checks, scene, "no light");
  CHECK(scene.CenterPixel()[0] == 0.0 && scene.CenterPixel()[3] > 0.1);
}

// A gradient of zero in half of the mesh, at one point alone, and everywhere but at one point.
void CheckZeroGradients(TestChecks& checks)
{
  LitScene scene;
  TestMeshes::SetField(
    scene.Grid, [](const double* p) { return 0.3 + std::max(p[0], 0.0); });
  CheckError(checks, scene, "half of the mesh is flat");
  scene.SetSpiky();
  CheckError(checks, scene, "half of the mesh is flat, spiky");
  scene.SetSmooth();
  auto cube = TestMeshes::SixTetrahedra();
  scene.SetGrid(cube);
  TestMeshes::SetField(cube, [](const double* p) { return p[0] + p[1] + p[2] > 1.4 ? 1.0 : 0.5; });
  CheckError(checks, scene, "one corner rises");
  TestMeshes::SetField(cube, [](const double* p) { return 0.5 + 1e-30 * p[0]; });
  CheckError(checks, scene, "a gradient next to nothing");
}
}

int TestBadLights(int, char*[])
{
  TestChecks checks;
  CheckDarkLights(checks);
  CheckZeroGradients(checks);
  return checks.Result();
}
