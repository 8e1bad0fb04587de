// M9 of lit volumes: after a change of any light, coefficient, function, scalar or point the next
// frame is that of a fresh mapper, and what does not depend on it is not made again.

#include "PreparedVolume.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkLight.h"
#include "vtkObjectFactory.h"

#include <array>
#include <functional>

namespace
{
/// Shows when its stages last worked.
class WatchedMapper : public vtkPreIntegratedTetrahedraMapper
{
public:
  static WatchedMapper* New();
  vtkTypeMacro(WatchedMapper, vtkPreIntegratedTetrahedraMapper);
  std::array<vtkMTimeType, 4> GetTimes() const
  {
    const PreparedVolume& prepared = this->GetPreparedVolume();
    return { { prepared.CellsTime, prepared.ScalarsTime, prepared.FunctionTime, this->GetTableTime() } };
  }
};
vtkStandardNewMacro(WatchedMapper);

class ChangingScene : public TestScene
{
public:
  vtkSmartPointer<vtkUnstructuredGrid> Grid = TestMeshes::Delaunay(60);
  vtkNew<vtkLight> Light;
  vtkNew<vtkPiecewiseFunction> GradientOpacity;

  ChangingScene()
    : TestScene(vtkSmartPointer<WatchedMapper>::New(), 64, 64)
  {
    TestMeshes::SetField(this->Grid, TestMeshes::Waves);
    this->SetGrid(this->Grid);
    this->Property->ShadeOn();
    this->Property->SetSpecular(0.4);
    this->Light->SetLightTypeToSceneLight();
    this->Light->SetPosition(1.0, 2.0, 3.0);
    this->Renderer->AddLight(this->Light);
    this->GradientOpacity->AddPoint(0.5, 0.2);
    this->GradientOpacity->AddPoint(2.0, 1.0);
  }

  double DifferenceToFresh()
  {
    this->Render();
    auto kept = this->CopyCaptured();
    vtkNew<vtkPreIntegratedTetrahedraMapper> fresh;
    fresh->SetInputData(this->Grid);
    fresh->SetIntegration(this->GetTetrahedraMapper()->GetIntegration());
    fresh->SetTableSize(this->GetTetrahedraMapper()->GetTableSize());
    fresh->CaptureImageOn();
    this->Volume->SetMapper(fresh);
    this->Render();
    const double difference = Difference(kept, fresh->GetCapturedImage());
    this->Volume->SetMapper(this->Mapper);
    return difference;
  }
};

/// What a change makes anew: nothing, the table, the function, the scalars and what follows, or all.
enum Depth
{
  Nothing = 4,
  Table = 3,
  Function = 2,
  Scalars = 1,
  All = 0
};

struct Change
{
  const char* Name;
  Depth Makes;
  std::function<void(ChangingScene&)> Apply;
};

std::vector<Change> Changes()
{
  return {
    { "ambient", Nothing, [](ChangingScene& s) { s.Property->SetAmbient(0.4); } },
    { "diffuse", Nothing, [](ChangingScene& s) { s.Property->SetDiffuse(0.5); } },
    { "specular", Nothing, [](ChangingScene& s) { s.Property->SetSpecular(0.8); } },
    { "specular power", Nothing, [](ChangingScene& s) { s.Property->SetSpecularPower(3.0); } },
    { "light moved", Nothing, [](ChangingScene& s) { s.Light->SetPosition(-3.0, 1.0, 0.5); } },
    { "light's colour", Nothing, [](ChangingScene& s) { s.Light->SetColor(1.0, 0.5, 0.2); } },
    { "light's intensity", Nothing, [](ChangingScene& s) { s.Light->SetIntensity(0.6); } },
    { "light positional", Nothing,
      [](ChangingScene& s)
      {
        s.Light->PositionalOn();
        s.Light->SetAttenuationValues(0.1, 0.2, 0.3);
      } },
    { "another light", Nothing,
      [](ChangingScene& s)
      {
        vtkNew<vtkLight> light;
        light->SetLightTypeToHeadlight();
        s.Renderer->AddLight(light);
      } },
    { "light off", Nothing, [](ChangingScene& s) { s.Light->SwitchOff(); } },
    { "camera", Nothing, [](ChangingScene& s) { s.LookFrom(-1.5, 0.7, -1.6); } },
    { "gradient opacity", Nothing,
      [](ChangingScene& s) { s.Property->SetGradientOpacity(s.GradientOpacity); } },
    { "gradient opacity's point", Nothing,
      [](ChangingScene& s) { s.GradientOpacity->AddPoint(1.0, 0.1); } },
    { "gradient opacity disabled", Nothing,
      [](ChangingScene& s) { s.Property->DisableGradientOpacityOn(); } },
    { "volume turned", Nothing, [](ChangingScene& s) { s.Volume->RotateX(50.0); } },
    { "unit distance", Function,
      [](ChangingScene& s) { s.Property->SetScalarOpacityUnitDistance(0.4); } },
    { "opacity", Function, [](ChangingScene& s) { s.Opacity->AddPoint(0.4, 5.0); } },
    { "colour", Function, [](ChangingScene& s) { s.Color->AddRGBPoint(0.3, 0.0, 1.0, 0.0); } },
    { "scalars", Scalars,
      [](ChangingScene& s)
      { TestMeshes::SetField(s.Grid, [](const double* p) { return p[0] + 0.5 + p[1] * p[2]; }); } },
    { "points", All,
      [](ChangingScene& s)
      {
        s.Grid->GetPoints()->SetPoint(8, 0.1, 0.05, 0.02);
        s.Grid->GetPoints()->Modified();
      } },
    { "unlit", Table, [](ChangingScene& s) { s.Property->ShadeOff(); } },
    { "lit again", Table, [](ChangingScene& s) { s.Property->ShadeOn(); } },
  };
}

void CheckChanges(TestChecks& checks, int integration)
{
  ChangingScene scene;
  scene.GetTetrahedraMapper()->SetIntegration(integration);
  scene.GetTetrahedraMapper()->SetTableSize(32);
  auto* mapper = static_cast<WatchedMapper*>(scene.Mapper.Get());
  scene.Render();
  for (const Change& change : Changes())
  {
    auto before = scene.CopyCaptured();
    const auto times = mapper->GetTimes();
    change.Apply(scene);
    const double difference = scene.DifferenceToFresh();
    checks.Check(difference == 0.0, change.Name, __LINE__, std::to_string(difference));
    scene.Render();
    const double effect = TestScene::Difference(before, scene.Mapper->GetCapturedImage());
    checks.Check(effect > 1e-3, "has an effect", __LINE__, change.Name);
    const bool hasTable = integration == vtkPreIntegratedTetrahedraMapper::TABLE;
    for (int stage = 0; stage <= Table; ++stage)
    {
      const bool made = mapper->GetTimes()[stage] != times[stage];
      const bool isNeeded = stage >= change.Makes && (stage != Table || hasTable);
      checks.Check(made == isNeeded, "made anew", __LINE__,
        std::string(change.Name) + ", stage " + std::to_string(stage));
    }
  }
}
}

int TestLightChanges(int, char*[])
{
  TestChecks checks;
  CheckChanges(checks, vtkPreIntegratedTetrahedraMapper::EXACT);
  CheckChanges(checks, vtkPreIntegratedTetrahedraMapper::TABLE);
  return checks.Result();
}
