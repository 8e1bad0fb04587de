// Light, gradient opacity and dependent components by both engines: the same image within the
// bounds of both; by Tiles the same bytes for any number of threads, repaired pixels included.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellCenterDepthSort.h"
#include "vtkDoubleArray.h"
#include "vtkLight.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkTransform.h"
#include "vtkVariant.h"

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>

namespace
{
class BothEngines : public TestScene
{
public:
  vtkSmartPointer<vtkUnstructuredGrid> Grid = TestMeshes::Delaunay(100);

  BothEngines()
    : TestScene(80, 70)
  {
    TestMeshes::SetField(this->Grid, TestMeshes::Waves);
    this->SetGrid(this->Grid);
    this->SetSpiky();
    this->Property->ShadeOn();
    this->Property->SetSpecular(0.3);
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(0.4, 0.9, 0.7);
    light->PositionalOn();
    light->SetAttenuationValues(0.2, 0.5, 1.5);
    light->SetConeAngle(60.0);
    light->SetExponent(2.5);
    this->Renderer->AddLight(light);
    this->Lamp = light;
  }

  void SetGradientOpacity()
  {
    vtkNew<vtkPiecewiseFunction> function;
    function->AddPoint(0.3, 0.1);
    function->AddPoint(1.2, 1.0);
    this->Property->SetGradientOpacity(function);
  }

  void SetTwoComponents()
  {
    vtkSmartPointer<vtkDataArray> scalars = this->Grid->GetPointData()->GetScalars();
    vtkNew<vtkDoubleArray> pairs;
    pairs->SetName("pairs");
    pairs->SetNumberOfComponents(2);
    for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
    {
      const double value = scalars->GetComponent(id, 0);
      pairs->InsertNextTuple2(1.0 - value * value, value);
    }
    this->Grid->GetPointData()->SetScalars(pairs);
    this->Property->IndependentComponentsOff();
  }

  double DifferenceOfEngines()
  {
    this->Mapper->SetEngineToRaster();
    this->Render();
    auto raster = this->CopyCaptured();
    this->DrawTiles();
    return Difference(raster, this->Mapper->GetCapturedImage());
  }

  vtkSmartPointer<vtkImageData> DrawTiles(int threads = 0)
  {
    this->Mapper->SetEngineToTiles();
    vtkSMPTools::Initialize(threads);
    this->Render();
    vtkSMPTools::Initialize();
    return this->CopyCaptured();
  }

  vtkVariant GetStatistic(const char* column)
  {
    return this->Mapper->GetLastStatistics()->GetValueByName(0, column);
  }

  vtkSmartPointer<vtkLight> Lamp;
};

void CheckEngines(
  TestChecks& checks, BothEngines& scene, const char* name, double bound = 1e-3)
{
  const double views[3][3] = { { 0.5, 0.8, 2.2 }, { 0.1, -0.05, 0.2 }, { -2.0, 0.0, 0.0 } };
  for (const auto& view : views)
  {
    scene.LookFrom(view[0], view[1], view[2]);
    const double difference = scene.DifferenceOfEngines();
    CHECK(scene.GetStatistic("Engine") == "Tiles");
    const bool good = difference >= 0.0 && difference <= bound;
    checks.Check(good, name, __LINE__, std::to_string(difference));
    std::cout << name << ": " << difference << "\n";
    auto two = scene.CopyCaptured();
    CHECK(TestScene::Difference(two, scene.DrawTiles(1)) == 0.0);
  }
}

// Every instruction set that this machine has, by grey light and by another.
void CheckTargets(TestChecks& checks)
{
  BothEngines scene;
  scene.LookFrom(0.5, 0.8, 2.2);
  for (const bool grey : { true, false })
  {
    scene.Lamp->SetColor(1.0, grey ? 1.0 : 0.7, grey ? 1.0 : 0.4);
    for (const int64_t target : hwy::SupportedAndGeneratedTargets())
    {
      hwy::GetChosenTarget().Update(target);
      const double difference = scene.DifferenceOfEngines();
      checks.Check(difference >= 0.0 && difference <= 1e-3, hwy::TargetName(target), __LINE__,
        std::to_string(difference));
    }
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

// Thin fragments are lit in a shorter way where light is grey: a millionth of blue changes nothing else.
class ThinScene : public BothEngines
{
public:
  explicit ThinScene(vtkUnstructuredGrid* grid)
  {
    TestMeshes::SetField(grid, TestMeshes::Waves);
    this->SetGrid(grid);
    this->SetSmooth();
    this->Lamp->SwitchOff();
    this->Head->SetLightTypeToHeadlight();
    this->Side->SetLightTypeToSceneLight();
    this->Side->SetPosition(-1.0, 0.7, 0.3);
    this->Side->SetIntensity(0.6);
    this->Renderer->AddLight(this->Head);
    this->Renderer->AddLight(this->Side);
  }

  void SetWaves(int points)
  {
    this->Opacity->RemoveAllPoints();
    for (int i = 0; i < points; ++i)
    {
      this->Opacity->AddPoint(i / (points - 1.0), 1.0 + 0.3 * std::sin(5.0 * i));
    }
  }

  // By the oracle's image as it is.
  double DrawError(bool shortWay)
  {
    this->Head->SetColor(1.0, 1.0, shortWay ? 1.0 : 1.0 + 1e-6);
    this->DrawTiles();
    this->Oracle->Compare(this->Mapper->GetCapturedImage());
    return this->Oracle->GetRootMeanSquareError();
  }

  void Check(TestChecks& checks, const char* name)
  {
    const double error = this->DrawError(false);
    auto parts = this->CopyCaptured();
    const double shortError = this->DrawError(true);
    std::cout << name << ": " << shortError << ", by parts " << error << "\n";
    checks.Check(shortError <= 1.1 * error, name, __LINE__, std::to_string(shortError));
    CHECK_AT_MOST(this->Oracle->GetMaximumError(), 1e-3);
    // It is taken: by rounding alone and by that blue they differ less.
    CHECK(Difference(parts, this->Mapper->GetCapturedImage()) > 1e-6);
  }

  void CheckAgain(TestChecks& checks, const char* name)
  {
    CHECK(this->UpdateOracle());
    this->Check(checks, name);
  }

  vtkNew<vtkLight> Head, Side;
};

void CheckThin(TestChecks& checks)
{
  ThinScene scene(TestMeshes::Delaunay(700));
  scene.LookFrom(0.1, -0.05, 0.2);
  scene.CheckAgain(checks, "thin, from inside");
  scene.Side->SwitchOff();
  scene.LookFrom(0.5, 0.8, 2.2);
  scene.CheckAgain(checks, "thin, headlight");
  // Look-ups in two registers and in memory, and vectors of which a part is cut and waits.
  for (const int points : { 10, 60 })
  {
    scene.SetWaves(points);
    scene.CheckAgain(checks, "thin, of many pieces");
  }
  scene.SetSmooth();
  scene.Side->SwitchOn();
  scene.Property->SetSpecularPower(7.0);
  scene.Volume->SetScale(1.0, 0.4, 1.3);
  scene.Volume->RotateZ(30.0);
  scene.CheckAgain(checks, "thin, scaled");
  scene.Property->SetSpecular(0.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  CHECK(scene.UpdateOracle());
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    scene.Check(checks, hwy::TargetName(target));
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

// No two vertices are alike: gradients turn by any angle within a cell.
double Noise(const double* p)
{
  const double wave = 1e4 * std::sin(12.9898 * p[0] + 78.233 * p[1] + 37.719 * p[2]);
  return wave - std::floor(wave);
}

// Without a gradient but in a corner.
double Corner(const double* p)
{
  return std::max(0.0, p[0] + p[1] + p[2] - 0.9);
}

// Thin fragments that light alone cuts, where it passes from one side to the other too; and light that is ambient
// alone.
void CheckSteep(TestChecks& checks)
{
  const auto grid = TestMeshes::Delaunay(700);
  ThinScene scene(grid);
  scene.Side->SwitchOff();
  scene.LookFrom(0.5, 0.8, 2.2);
  for (const double distance : { 1.0, 3.0 })
  {
    scene.Property->SetScalarOpacityUnitDistance(distance);
    TestMeshes::SetField(grid, Noise);
    scene.CheckAgain(checks, "steep");
    std::cout << scene.Oracle->GetMaximumError() << " at most\n";
    CHECK_AT_MOST(scene.Oracle->GetMaximumError(), 2e-4);
    TestMeshes::SetField(grid, Corner);
    scene.CheckAgain(checks, "no gradient");
    std::cout << scene.Oracle->GetMaximumError() << " at most\n";
    CHECK_AT_MOST(scene.Oracle->GetMaximumError(), 1e-4);
  }
}

// The same picture in any unit of length: the same fragments are lit in the shorter way.
void CheckThinUnits(TestChecks& checks)
{
  ThinScene scene(TestMeshes::Delaunay(700));
  vtkSmartPointer<vtkImageData> whole;
  for (const int power : { 0, -33, -20, -10, 10, 20 })
  {
    const double unit = std::ldexp(1.0, power);
    scene.Volume->SetScale(unit);
    scene.Property->SetScalarOpacityUnitDistance(unit);
    scene.Renderer->GetActiveCamera()->SetPosition(0.5 * unit, 0.8 * unit, 2.2 * unit);
    scene.Renderer->GetActiveCamera()->SetClippingRange(0.1 * unit, 20.0 * unit);
    // The oracle's image is that of the first one.
    CHECK(power != 0 || scene.UpdateOracle());
    scene.Check(checks, "thin, in another unit");
    whole = power == 0 ? scene.CopyCaptured() : whole;
    const double difference = TestScene::Difference(whole, scene.Mapper->GetCapturedImage());
    std::cout << "from 1 to 2 to the power of " << power << ": " << difference << "\n";
    CHECK(difference >= 0.0 && difference <= 1e-6);
  }
}

// A camera along z that undoes the stretching of the volume: angles are kept on the way to the eye,
// lengths in the world are not.
void CheckStretched(TestChecks& checks)
{
  BothEngines scene;
  scene.Volume->SetScale(1.0, 1.0, 3.0);
  vtkNew<vtkTransform> squeeze;
  squeeze->Scale(1.0, 1.0, 1.0 / 3.0);
  scene.Renderer->GetActiveCamera()->SetUserViewTransform(squeeze);
  scene.LookFrom(0.0, 0.0, 6.0);
  const double difference = scene.DifferenceOfEngines();
  CHECK(difference >= 0.0);
  CHECK_AT_MOST(difference, 1e-3);
}

// Cut by a plane, with opaque media and pixels that are repaired, in both projections.
void CheckSpecialCases(TestChecks& checks)
{
  BothEngines scene;
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.3, 0.2, -1.0);
  plane->SetOrigin(0.0, 0.0, 0.1);
  scene.Mapper->AddClippingPlane(plane);
  CheckEngines(checks, scene, "clipped");
  // Any order comes out right.
  auto inOrder = scene.CopyCaptured();
  vtkNew<vtkCellCenterDepthSort> sort;
  scene.GetTetrahedraMapper()->SetVisibilitySort(sort);
  CHECK_AT_MOST(TestScene::Difference(inOrder, scene.DrawTiles()), 1e-4);
  CHECK(scene.GetStatistic("RepairedPixels").ToInt() > 0);
  scene.GetTetrahedraMapper()->SetVisibilitySort(nullptr);
  scene.Property->SetScalarOpacityUnitDistance(0.02);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.9);
  CheckEngines(checks, scene, "opaque, parallel");
}
}

int TestTilesLight(int, char*[])
{
  TestChecks checks;
  BothEngines scene;
  CheckEngines(checks, scene, "lit");
  scene.SetGradientOpacity();
  CheckEngines(checks, scene, "lit, gradient opacity");
  scene.SetTwoComponents();
  CheckEngines(checks, scene, "lit, gradient opacity, two components");
  scene.Property->DisableGradientOpacityOn();
  CheckEngines(checks, scene, "lit, two components");
  scene.Property->ShadeOff();
  CheckEngines(checks, scene, "two components", 1e-4);
  CheckSpecialCases(checks);
  CheckTargets(checks);
  CheckStretched(checks);
  CheckThin(checks);
  CheckThinUnits(checks);
  CheckSteep(checks);
  return checks.Result();
}
