/**
 * Transfer functions that are not linear between their nodes, along one ray of length 2 on which s
 * is linear: steps and HSV against closed forms, every other kind against a sum over 400,000 steps.
 */

#include "TestOracleScene.h"

namespace
{
const double Length = 2.0;

/** Draws the one pixel; s runs from `last` at the back (z = -1) to `first` at the front. */
void Draw(TestOracleChecks& checks, TestOracleScene& scene, double first, double last)
{
  TestOracleBox box;
  box.CellType = VTK_TETRA;
  box.Field = [=](double, double, double z)
  { return first * (1.0 + z) / 2.0 + last * (1.0 - z) / 2.0; };
  scene.Camera->SetPosition(0.11, 0.07, 5.0);
  scene.Camera->SetFocalPoint(0.11, 0.07, 0.0);
  scene.Oracle->SetSize(1, 1);
  CHECK_TRUE(checks, scene.Draw(box.Build()));
}

/** Opacity 0 below s = .3 and 1 above, by two nodes at one place. */
void CheckStep(TestOracleChecks& checks)
{
  TestOracleScene scene;
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AllowDuplicateScalarsOn();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Opacity->AddPoint(0.3, 0.0);
  scene.Opacity->AddPoint(0.3, 1.0);
  scene.Opacity->AddPoint(1.0, 1.0);
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  Draw(checks, scene, 0.9, 0.1);
  // s > .3 over 6/8 of the ray.
  CHECK_NEAR(checks, scene.GetValue(0, 0, 3), 1.0 - std::exp(-0.75 * Length), 1e-9);
}

/** Hue from red to green: (1, 2 s, 0) up to yellow at s = 1/2, (2 - 2 s, 1, 0) behind it. */
void CheckHue(TestOracleChecks& checks)
{
  TestOracleScene scene;
  scene.Color->RemoveAllPoints();
  scene.Color->SetColorSpaceToHSV();
  scene.Color->HSVWrapOff();
  scene.Color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  scene.Color->AddRGBPoint(1.0, 0.0, 1.0, 0.0);
  scene.SetExtinction(1.5);
  scene.Oracle->SetBlendMode(vtkCellProjectionOracle::ADDITIVE_BLEND);
  Draw(checks, scene, 0.9, 0.0);
  const double unit = 1.5 * Length / 0.9; // per scalar
  CHECK_NEAR(checks, scene.GetValue(0, 0, 0), unit * (0.5 + 0.24), 1e-9);
  CHECK_NEAR(checks, scene.GetValue(0, 0, 1), unit * (0.25 + 0.4), 1e-9);
}

/** The optical model as a sum over the middles of many short steps. */
std::array<double, 4> Sum(vtkVolumeProperty* property, double first, double last)
{
  const int count = 400000;
  const double step = Length / count;
  std::array<double, 4> sum = {};
  double depth = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double s = first + (last - first) * (i + 0.5) / count;
    std::array<double, 3> color;
    if (property->GetColorChannels() == 1)
    {
      color.fill(property->GetGrayTransferFunction()->GetValue(s));
    }
    else
    {
      property->GetRGBTransferFunction()->GetColor(s, color.data());
    }
    const double thickness =
      step * property->GetScalarOpacity()->GetValue(s) / property->GetScalarOpacityUnitDistance();
    for (int channel = 0; channel < 3; ++channel)
    {
      sum[channel] += color[channel] * thickness * std::exp(-depth - thickness / 2.0);
    }
    depth += thickness;
  }
  sum[3] = 1.0 - std::exp(-depth);
  return sum;
}

using Change = std::function<void(TestOracleScene& scene)>;

void CheckAgainstSum(TestOracleChecks& checks, double first, double last, const Change& change)
{
  TestOracleScene scene;
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(0.0, 0.1, 0.2, 0.9);
  scene.Color->AddRGBPoint(0.5, 0.9, 0.3, 0.2);
  scene.Color->AddRGBPoint(1.0, 0.2, 0.8, 0.3);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.2);
  scene.Opacity->AddPoint(0.75, 0.9);
  scene.Opacity->AddPoint(1.0, 0.4);
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(0.7);
  change(scene);
  Draw(checks, scene, first, last);
  const std::array<double, 4> expected = Sum(scene.Volume->GetProperty(), first, last);
  for (int component = 0; component < 4; ++component)
  {
    CHECK_NEAR(checks, scene.GetValue(0, 0, component), expected[component], 2e-9);
  }
}

void CheckKinds(TestOracleChecks& checks)
{
  const Change changes[] = { [](TestOracleScene&) {},
    [](TestOracleScene& scene) { scene.Color->SetColorSpaceToHSV(); },
    [](TestOracleScene& scene) { scene.Color->SetColorSpaceToLab(); },
    [](TestOracleScene& scene) { scene.Color->SetColorSpaceToDiverging(); },
    [](TestOracleScene& scene) { scene.Color->AddRGBPoint(0.25, 0.3, 0.9, 0.1, 0.75, 0.6); },
    [](TestOracleScene& scene) { scene.Opacity->AddPoint(0.25, 0.1, 0.25, 0.5); },
    // Sharpness 1: a step in every colour function, and in an opacity function before VTK 9.6.
    [](TestOracleScene& scene) { scene.Color->AddRGBPoint(0.5, 0.9, 0.3, 0.2, 0.5, 1.0); },
    [](TestOracleScene& scene) { scene.Opacity->AddPoint(0.25, 0.1, 0.2, 1.0); },
    [](TestOracleScene& scene)
    { scene.Volume->GetProperty()->SetColor(scene.Opacity.GetPointer()); } };
  for (const Change& change : changes)
  {
    CheckAgainstSum(checks, 0.0, 1.0, change);
    CheckAgainstSum(checks, 1.0, 0.0, change);
  }
  // Beyond the nodes: held by clamping, zero without it; the steps are at 1/4 and 3/4 of the ray.
  CheckAgainstSum(checks, -0.5, 1.5, [](TestOracleScene&) {});
  CheckAgainstSum(checks, -0.5, 1.5,
    [](TestOracleScene& scene)
    {
      scene.Color->ClampingOff();
      scene.Opacity->ClampingOff();
    });
  CheckAgainstSum(checks, 0.5, 1.0,
    [](TestOracleScene& scene)
    {
      scene.Color->RemovePoint(0.0);
      scene.Color->SetScaleToLog10();
    });
}
}

int TestOracleFunctions(int, char*[])
{
  TestOracleChecks checks(__FILE__);
  CheckStep(checks);
  CheckHue(checks);
  CheckKinds(checks);
  return checks.GetResult();
}
