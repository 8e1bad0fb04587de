/**
 * The statistics against images whose differences are made by hand, and every refusal: one error
 * each and no image.
 */

#include "TestOracleScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"

namespace
{
/** Counts the errors of an object instead of letting them be printed. */
class ErrorCounter
{
public:
  explicit ErrorCounter(vtkObject* object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* data, void*)
      { ++static_cast<ErrorCounter*>(data)->Count; });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  int Count = 0;

private:
  vtkNew<vtkCallbackCommand> Command;
};

void CheckStatistics(TestOracleChecks& checks)
{
  TestOracleScene scene;
  scene.Camera->SetPosition(1.0, 2.0, 9.0);
  CHECK_TRUE(checks, scene.Draw(TestOracleBox().Build()));
  vtkImageData* image = scene.Oracle->GetImage();
  vtkNew<vtkImageData> copy;
  copy->DeepCopy(image);
  scene.Oracle->Compare(copy);
  const vtkIdType covered = scene.Oracle->GetNumberOfCoveredPixels();
  CHECK_TRUE(checks, covered > 50 && covered < scene.Width * scene.Height);
  CHECK_TRUE(checks, image->GetScalarComponentAsDouble(0, 0, 0, 3) == 0.0);
  CHECK_NEAR(checks, scene.Oracle->GetRootMeanSquareError(), 0.0, 0.0);
  CHECK_NEAR(checks, scene.Oracle->GetMaximumError(), 0.0, 0.0);

  // One empty pixel lit by .3, one covered pixel off by .1 in green and by less in red.
  const int x = scene.Width / 2, y = scene.Height / 2;
  copy->SetScalarComponentFromDouble(0, 0, 0, 2, 0.3);
  copy->SetScalarComponentFromDouble(x, y, 0, 1, scene.GetValue(x, y, 1) - 0.1);
  copy->SetScalarComponentFromDouble(x, y, 0, 0, scene.GetValue(x, y, 0) + 0.05);
  scene.Oracle->Compare(copy);
  const double count = static_cast<double>(covered + 1);
  CHECK_TRUE(checks, scene.Oracle->GetNumberOfCoveredPixels() == covered + 1);
  CHECK_NEAR(checks, scene.Oracle->GetMaximumError(), 0.3, 1e-12);
  CHECK_NEAR(checks, scene.Oracle->GetRootMeanSquareError(), std::sqrt(0.1 / count), 1e-12);
  CHECK_NEAR(checks, scene.Oracle->GetShareAboveHalfLevel(), 2.0 / count, 1e-12);
  // Of fewer than 1000 pixels the 99.9th percentile is the largest.
  CHECK_NEAR(checks, scene.Oracle->GetPercentileError(), 0.3, 1e-12);
  int pixel[2];
  scene.Oracle->GetMaximumErrorPixel(pixel);
  CHECK_TRUE(checks, pixel[0] == 0 && pixel[1] == 0);

  copy->SetScalarComponentFromDouble(x, y, 0, 3, std::numeric_limits<double>::quiet_NaN());
  scene.Oracle->Compare(copy);
  scene.Oracle->GetMaximumErrorPixel(pixel);
  CHECK_TRUE(checks, std::isinf(scene.Oracle->GetMaximumError()));
  CHECK_TRUE(checks, pixel[0] == x && pixel[1] == y);
}

/** More than 1000 covered pixels, of which exactly one in a thousand may exceed the percentile. */
void CheckPercentile(TestOracleChecks& checks)
{
  TestOracleScene scene;
  scene.Oracle->SetSize(50, 40);
  scene.Camera->SetPosition(0.0, 0.0, 0.0);
  scene.Camera->SetFocalPoint(0.0, 0.0, -1.0);
  CHECK_TRUE(checks, scene.Draw(TestOracleBox().Build()));
  vtkNew<vtkImageData> copy;
  copy->DeepCopy(scene.Oracle->GetImage());
  for (int column = 0; column < 3; ++column)
  {
    const double error = 0.1 * (column + 1);
    copy->SetScalarComponentFromDouble(column, 7, 0, 3, scene.GetValue(column, 7, 3) + error);
  }
  scene.Oracle->Compare(copy);
  CHECK_TRUE(checks, scene.Oracle->GetNumberOfCoveredPixels() == 2000);
  CHECK_NEAR(checks, scene.Oracle->GetPercentileError(), 0.1, 1e-12);
}

using Spoil = std::function<void(TestOracleScene& scene)>;

void CheckRefusals(TestOracleChecks& checks)
{
  vtkNew<vtkDoubleArray> shortArray;
  shortArray->SetNumberOfTuples(7);
  const Spoil spoils[] = { [](TestOracleScene& scene) { scene.Oracle->SetInputData(nullptr); },
    [](TestOracleScene& scene) { scene.Oracle->SetVolume(nullptr); },
    [](TestOracleScene& scene) { scene.Oracle->SetCamera(nullptr); },
    [](TestOracleScene& scene) { scene.Oracle->SetSize(0, 5); },
    [](TestOracleScene& scene) { scene.Oracle->SetBlendMode(3); },
    [](TestOracleScene& scene) { scene.Oracle->SetArrayName("absent"); },
    [](TestOracleScene& scene) { scene.Oracle->SetCellScalars(true); },
    [](TestOracleScene& scene) { scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(0.0); },
    [&](TestOracleScene& scene) { scene.Oracle->SetOpaqueDepth(shortArray); } };
  for (const Spoil& spoil : spoils)
  {
    TestOracleScene scene;
    CHECK_TRUE(checks, scene.Draw(TestOracleBox().Build()));
    ErrorCounter errors(scene.Oracle);
    spoil(scene);
    CHECK_TRUE(checks, !scene.Oracle->Update());
    CHECK_TRUE(checks, errors.Count == 1);
    CHECK_TRUE(checks, scene.Oracle->GetImage() == nullptr);
    scene.Oracle->Compare(nullptr);
    CHECK_TRUE(checks, errors.Count == 2);
    CHECK_TRUE(checks, std::isinf(scene.Oracle->GetMaximumError()));
  }
}

/** An empty grid is no error: an empty image, and nothing to compare. */
void CheckEmpty(TestOracleChecks& checks)
{
  TestOracleScene scene;
  TestOracleBox box;
  box.Blocks = { 0, 0, 0 };
  CHECK_TRUE(checks, scene.Draw(box.Build()));
  CHECK_TRUE(checks, scene.Oracle->GetNumberOfSegments() == 0);
  scene.Oracle->Compare(scene.Oracle->GetImage());
  CHECK_TRUE(checks, scene.Oracle->GetNumberOfCoveredPixels() == 0);
  vtkNew<vtkImageData> wrong;
  wrong->SetDimensions(3, 3, 1);
  wrong->AllocateScalars(VTK_FLOAT, 4);
  ErrorCounter errors(scene.Oracle);
  scene.Oracle->Compare(wrong);
  CHECK_TRUE(checks, errors.Count == 1);
}
}

int TestOracleCompare(int, char*[])
{
  TestOracleChecks checks(__FILE__);
  CheckStatistics(checks);
  CheckPercentile(checks);
  CheckRefusals(checks);
  CheckEmpty(checks);
  return checks.GetResult();
}
