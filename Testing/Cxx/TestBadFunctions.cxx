// Functions of a property that nobody means: vertical steps, one point, points that are not finite,
// opacities above 1 and below 0. Each is drawn as stated, against the oracle, by Raster and by what is
// chosen.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkMaximumProjectionMapper.h"

#include <cmath>
#include <functional>
#include <limits>

namespace
{
const double Nan = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

class FunctionScene : public TestScene
{
public:
  FunctionScene(int engine, bool lit)
    : TestScene(48, 48)
  {
    auto grid = TestMeshes::Delaunay(80);
    TestMeshes::SetField(grid, TestMeshes::Waves);
    this->SetGrid(grid);
    this->Mapper->SetEngine(engine);
    this->Property->SetShade(lit);
    this->Property->SetSpecular(0.4);
    this->Bound = lit ? 1e-3 : 1e-4;
    this->Messages->Watch(this->Mapper);
  }

  double Bound;
  vtkNew<MessageObserver> Messages;
};

void CheckError(TestChecks& checks, FunctionScene& scene, const std::string& name)
{
  const double error = scene.MaximumError(name);
  checks.Check(
    error >= 0.0 && error <= scene.Bound, name.c_str(), __LINE__, std::to_string(error));
}

// Two points at one scalar: whichever side a cell is on, it has that side's value.
void CheckSteps(TestChecks& checks, int engine, bool lit)
{
  FunctionScene opacity(engine, lit);
  opacity.Opacity->AllowDuplicateScalarsOn();
  opacity.Opacity->RemoveAllPoints();
  for (int i = 1; i < 5; ++i)
  {
    opacity.Opacity->AddPoint(0.2 * i, i % 2 == 0 ? 8.0 : 0.0);
    opacity.Opacity->AddPoint(0.2 * i, i % 2 == 0 ? 0.0 : 8.0);
  }
  CheckError(checks, opacity, "steps of opacity");
  FunctionScene color(engine, lit);
  color.Color->AllowDuplicateScalarsOn();
  color.Color->RemoveAllPoints();
  for (int i = 1; i < 5; ++i)
  {
    color.Color->AddRGBPoint(0.2 * i, i % 2, 0.5, 0.1 * i);
    color.Color->AddRGBPoint(0.2 * i, 0.1 * i, i % 3 / 2.0, 1.0);
  }
  CheckError(checks, color, "steps of colour");
  // A step is as sharp in a table as the table is fine.
  color.GetTetrahedraMapper()->SetIntegrationToTable();
  const double table = color.MaximumError("steps of colour, table");
  CHECK(table >= 0.0);
  CHECK_AT_MOST(table, 0.05);
  CHECK(opacity.Messages->Count() == 0 && color.Messages->Count() == 0);
}

void CheckOnePoint(TestChecks& checks, int engine, bool lit)
{
  FunctionScene scene(engine, lit);
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(0.4, 0.9, 0.5, 0.2);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.6, 3.0);
  CheckError(checks, scene, "one point each");
  CHECK(scene.CenterPixel()[3] > 0.1);
  // Below and above there is nothing.
  scene.Opacity->ClampingOff();
  scene.Opacity->AddPoint(0.5, 3.0);
  CheckError(checks, scene, "clamping off");
  CHECK(scene.Messages->Count() == 0);
}

void CheckRange(TestChecks& checks, int engine, bool lit)
{
  FunctionScene above(engine, lit);
  above.Opacity->RemoveAllPoints();
  above.Opacity->AddPoint(0.3, 0.0);
  above.Opacity->AddPoint(0.7, 1e4);
  CheckError(checks, above, "opacity above 1");
  CHECK(above.Messages->Count() == 0);
  // What counts as 0 begins between the points.
  FunctionScene below(engine, lit);
  below.Opacity->RemoveAllPoints();
  below.Opacity->AddPoint(0.2, -6.0);
  below.Opacity->AddPoint(0.5, 6.0);
  below.Opacity->AddPoint(0.8, -2.0);
  CheckError(checks, below, "opacity below 0");
  below.Render();
  CHECK(below.Messages->Count() == 1);
  CHECK(below.Messages->CountOf("2 points of the property's scalar opacity function are below 0") == 1);
}

void CheckNotFinite(TestChecks& checks, int engine, bool lit)
{
  FunctionScene scene(engine, lit);
  scene.Render();
  const auto good = scene.CopyCaptured();
  scene.Opacity->AddPoint(0.3, Nan);
  scene.Opacity->AddPoint(0.6, Infinity);
  scene.Color->AddRGBPoint(0.45, 0.1, Nan, 0.3);
  scene.Render();
  scene.Render();
  CHECK(TestScene::Difference(good, scene.Mapper->GetCapturedImage()) == 0.0);
  CHECK(scene.Messages->CountOf("2 points of the property's scalar opacity function are not finite") == 1);
  CHECK(scene.Messages->CountOf("1 points of the property's colour function are not finite") == 1);
  // What is left of it is the oracle's.
  scene.SetSmooth();
  CheckError(checks, scene, "points that are not finite removed");
  // Nothing is left.
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.5, Nan);
  scene.Render();
  CHECK(scene.CenterPixel()[3] > 0.1);
  CHECK(scene.Messages->CountOf("1 points of the property's scalar opacity") == 1);
}

void CheckGradientOpacity(TestChecks& checks)
{
  FunctionScene scene(vtkConvexCellMapper::RASTER, true);
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.2, -0.5);
  function->AddPoint(1.5, 1.0);
  scene.Property->SetGradientOpacity(function);
  scene.Render();
  const auto good = scene.CopyCaptured();
  function->AddPoint(0.8, Nan);
  scene.Render();
  CHECK(TestScene::Difference(good, scene.Mapper->GetCapturedImage()) == 0.0);
  const int pixels[2] = { 15, 30 };
  for (const double value : scene.Pixel(pixels[0], pixels[1]))
  {
    CHECK(value >= 0.0 && value < 10.0);
  }
}

// An opacity of a pixel is no extinction: more than 1 is 1.
void CheckMaximum(TestChecks& checks)
{
  TestScene scene(vtkNew<vtkMaximumProjectionMapper>(), 64, 64);
  scene.SetGrid(TestMeshes::Delaunay(80));
  scene.Opacity->AddPoint(0.0, -3.0);
  scene.Opacity->AddPoint(1.0, 5.0);
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  const double error = scene.MaximumError("maximum");
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 1e-4);
  CHECK(messages->Count() == 1 && messages->CountOf("below 0") == 1);
}
}

int TestBadFunctions(int, char*[])
{
  TestChecks checks;
  for (const int engine : { vtkConvexCellMapper::RASTER, vtkConvexCellMapper::AUTOMATIC })
  {
    for (const bool lit : { false, true })
    {
      CheckSteps(checks, engine, lit);
      CheckOnePoint(checks, engine, lit);
      CheckRange(checks, engine, lit);
      CheckNotFinite(checks, engine, lit);
    }
  }
  CheckGradientOpacity(checks);
  CheckMaximum(checks);
  return checks.Result();
}
