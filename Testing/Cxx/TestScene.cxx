#include "TestScene.h"

#include "FaceOrderSort.h"
#include "SnappedVertices.h"
#include "vtkConvexCells.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

//------------------------------------------------------------------------------
TestScene::TestScene(int width, int height)
  : TestScene(vtkNew<vtkPreIntegratedTetrahedraMapper>(), width, height)
{
  vtkNew<FaceOrderSort> sort;
  this->GetTetrahedraMapper()->SetVisibilitySort(sort);
  this->TakeTestEngine();
}

//------------------------------------------------------------------------------
void TestScene::TakeTestEngine()
{
  const char* engine = std::getenv("CELLPROJECTION_TEST_ENGINE");
  if (engine)
  {
    this->Mapper->SetEngine(
      std::string(engine) == "Raster" ? vtkConvexCellMapper::RASTER : vtkConvexCellMapper::TILES);
  }
}

//------------------------------------------------------------------------------
TestScene::TestScene(vtkConvexCellMapper* mapper, int width, int height)
  : Mapper(mapper)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AddVolume(this->Volume);
  this->Volume->SetMapper(this->Mapper);
  this->Volume->SetProperty(this->Property);
  this->Property->SetColor(this->Color);
  this->Property->SetScalarOpacity(this->Opacity);
  this->Property->SetInterpolationTypeToLinear();
  this->SetSmooth();
  this->Mapper->CaptureImageOn();
  SnappedVertices::TakeTestEnvironment(this->Renderer);
  this->LookFrom(0.5, 0.8, 2.2);
}

//------------------------------------------------------------------------------
void TestScene::LookFrom(double x, double y, double z)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(x, y, z);
  camera->SetClippingRange(0.1, 20.0);
}

//------------------------------------------------------------------------------
vtkPreIntegratedTetrahedraMapper* TestScene::GetTetrahedraMapper()
{
  return vtkPreIntegratedTetrahedraMapper::SafeDownCast(this->Mapper);
}

//------------------------------------------------------------------------------
void TestScene::SetGrid(vtkUnstructuredGrid* grid)
{
  this->Mapper->SetInputData(grid);
  this->Oracle->SetInputData(grid);
}

//------------------------------------------------------------------------------
void TestScene::SetConstant(double opacity)
{
  this->Color->RemoveAllPoints();
  this->Color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(0.0, opacity);
}

//------------------------------------------------------------------------------
void TestScene::SetSmooth()
{
  this->Color->RemoveAllPoints();
  this->Color->AddRGBPoint(0.0, 0.1, 0.2, 0.9);
  this->Color->AddRGBPoint(0.5, 0.9, 0.9, 0.2);
  this->Color->AddRGBPoint(1.0, 0.9, 0.1, 0.1);
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(0.0, 0.1);
  this->Opacity->AddPoint(1.0, 2.0);
}

//------------------------------------------------------------------------------
void TestScene::SetSpiky()
{
  this->SetSmooth();
  this->Opacity->RemoveAllPoints();
  for (int i = 0; i < 9; ++i)
  {
    this->Opacity->AddPoint(i / 8.0, i % 2 == 0 ? 0.0 : 4.0 + 6.0 * (i % 3));
  }
}

//------------------------------------------------------------------------------
void TestScene::Render()
{
  this->Window->Render();
}

//------------------------------------------------------------------------------
bool TestScene::UpdateOracle()
{
  const int* size = this->Renderer->GetSize();
  this->Oracle->SetVolume(this->Volume);
  this->Oracle->SetCamera(this->Renderer->GetActiveCamera());
  this->Oracle->SetLights(this->Renderer->GetLights());
  this->Oracle->SetSize(size[0], size[1]);
  // The oracle's numbers are the mappers'.
  this->Oracle->SetBlendMode(this->Mapper->GetBlendMode());
  return this->Oracle->Update();
}

//------------------------------------------------------------------------------
double TestScene::MaximumError(const std::string& name)
{
  this->Render();
  vtkImageData* captured = this->Mapper->GetCapturedImage();
  if (!captured)
  {
    std::cerr << name << ": no image was captured\n";
    return -1.0;
  }
  if (!this->UpdateOracle())
  {
    return -1.0;
  }
  this->Oracle->Compare(captured);
  const double maximum = this->Oracle->GetMaximumError();
  std::cout << name << ": covered " << this->Oracle->GetNumberOfCoveredPixels() << " RMSE "
            << this->Oracle->GetRootMeanSquareError() << " 99.9 % "
            << this->Oracle->GetPercentileError() << " maximum " << maximum << "\n";
  int worst[2];
  this->Oracle->GetMaximumErrorPixel(worst);
  std::cout << "  worst pixel " << worst[0] << " " << worst[1] << ":";
  for (int i = 0; i < 4; ++i)
  {
    std::cout << "  " << captured->GetScalarComponentAsDouble(worst[0], worst[1], 0, i) << " for "
              << this->Oracle->GetImage()->GetScalarComponentAsDouble(worst[0], worst[1], 0, i);
  }
  std::cout << "\n";
  // An image of nothing is right about nothing.
  return this->Oracle->GetNumberOfCoveredPixels() > 0 ? maximum : -1.0;
}

//------------------------------------------------------------------------------
std::array<double, 4> TestScene::Pixel(int x, int y)
{
  std::array<double, 4> value{ { -1.0, -1.0, -1.0, -1.0 } };
  vtkImageData* image = this->Mapper->GetCapturedImage();
  for (int i = 0; image && i < 4; ++i)
  {
    value[i] = image->GetScalarComponentAsDouble(x, y, 0, i);
  }
  return value;
}

//------------------------------------------------------------------------------
std::array<double, 4> TestScene::CenterPixel()
{
  const int* size = this->Renderer->GetSize();
  return this->Pixel(size[0] / 2, size[1] / 2);
}

//------------------------------------------------------------------------------
void TestScene::SetMesh(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(grid);
  cut->TetrahedraOnlyOn();
  cut->Update();
  this->Mapper->SetInputData(grid);
  this->Oracle->SetInputData(cut->GetOutput());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderer> TestScene::AddSecondViewport()
{
  auto second = vtkSmartPointer<vtkRenderer>::New();
  this->Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  second->AddVolume(this->Volume);
  second->SetActiveCamera(this->Renderer->GetActiveCamera());
  this->Window->AddRenderer(second);
  return second;
}

//------------------------------------------------------------------------------
vtkIdType TestScene::GetStatistic(const char* column)
{
  return this->Mapper->GetLastStatistics()->GetValueByName(0, column).ToLongLong();
}

//------------------------------------------------------------------------------
void TestScene::CheckCellsLeftOut(TestChecks& checks, double wide, vtkIdType cells)
{
  for (const double angle : { wide, 5.0 })
  {
    this->Renderer->GetActiveCamera()->SetViewAngle(angle);
    this->Render();
    const vtkIdType drawn = this->GetStatistic("CellsDrawn");
    const vtkIdType outside = this->GetStatistic("CellsSkippedOutside");
    CHECK((outside > 0) == (angle < 10.0));
    CHECK(drawn > 0);
    CHECK(drawn + outside + this->GetStatistic("CellsSkippedTransparent") == cells);
  }
}

//------------------------------------------------------------------------------
void TestScene::SetReportSmooth(vtkUnstructuredGrid* grid)
{
  double range[2];
  grid->GetScalarRange(range);
  const auto at = [&range](double share) { return range[0] + share * (range[1] - range[0]); };
  this->Color->RemoveAllPoints();
  this->Color->AddRGBPoint(at(0.0), 0.1, 0.2, 0.8);
  this->Color->AddRGBPoint(at(0.35), 0.2, 0.9, 0.9);
  this->Color->AddRGBPoint(at(1.0), 1.0, 0.3, 0.1);
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(at(0.0), 0.02);
  this->Opacity->AddPoint(at(0.3), 0.2);
  this->Opacity->AddPoint(at(1.0), 1.0);
  this->Property->SetScalarOpacityUnitDistance(grid->GetLength() / 20.0);
}

//------------------------------------------------------------------------------
double TestScene::Difference(vtkImageData* a, vtkImageData* b)
{
  if (!a || !b || a->GetNumberOfPoints() != b->GetNumberOfPoints())
  {
    return -1.0;
  }
  vtkDataArray* valuesA = a->GetPointData()->GetScalars();
  vtkDataArray* valuesB = b->GetPointData()->GetScalars();
  double largest = 0.0;
  for (vtkIdType id = 0; id < valuesA->GetNumberOfTuples(); ++id)
  {
    for (int i = 0; i < 4; ++i)
    {
      const double difference = valuesA->GetComponent(id, i) - valuesB->GetComponent(id, i);
      largest = std::max(largest, std::abs(difference));
    }
  }
  return largest;
}

//------------------------------------------------------------------------------
int TestScene::CountDifferent(vtkImageData* a, vtkImageData* b, double bound)
{
  int count = 0;
  for (vtkIdType pixel = 0; pixel < a->GetNumberOfPoints(); ++pixel)
  {
    bool differs = false;
    for (int i = 0; i < 4; ++i)
    {
      const double difference = a->GetPointData()->GetScalars()->GetComponent(pixel, i) -
                                b->GetPointData()->GetScalars()->GetComponent(pixel, i);
      differs = differs || !(std::abs(difference) <= bound);
    }
    count += differs ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> TestScene::CopyCaptured()
{
  auto copy = vtkSmartPointer<vtkImageData>::New();
  if (this->Mapper->GetCapturedImage())
  {
    copy->DeepCopy(this->Mapper->GetCapturedImage());
  }
  return copy;
}
