#include "BenchmarkScene.h"

#include "vtkAppendFilter.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkConvexCells.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockPLOT3DReader.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeMapper.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>

namespace
{
vtkSmartPointer<vtkUnstructuredGrid> Unstructured(vtkDataSet* mesh)
{
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(mesh);
  append->Update();
  return append->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> ReadBluntFin(const std::string& folder)
{
  vtkNew<vtkMultiBlockPLOT3DReader> reader;
  reader->SetXYZFileName((folder + "/bluntfinxyz.bin").c_str());
  reader->SetQFileName((folder + "/bluntfinq.bin").c_str());
  reader->SetScalarFunctionNumber(100);
  reader->Update();
  return Unstructured(vtkDataSet::SafeDownCast(reader->GetOutput()->GetBlock(0)));
}

// A bent lattice of about as many cells as Blunt Fin, with a wave in its density.
vtkSmartPointer<vtkUnstructuredGrid> MakeCurvilinear()
{
  const int size[3] = { 40, 32, 32 };
  vtkNew<vtkStructuredGrid> grid;
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> density;
  density->SetName("Density");
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const double angle = 2.0 * i / (size[0] - 1.0);
        const double radius = 1.0 + std::pow(j / (size[1] - 1.0), 1.5);
        const double z = 2.0 * k / (size[2] - 1.0);
        points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), z);
        density->InsertNextValue(2.0 + 2.0 * std::sin(4.0 * angle) * std::cos(3.0 * radius + z));
      }
    }
  }
  grid->SetDimensions(size);
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(density);
  return Unstructured(grid);
}

void SetProperty(vtkVolumeProperty* property, const double range[2], double diagonal, bool spiky)
{
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  auto at = [&](double share) { return range[0] + share * (range[1] - range[0]); };
  color->AddRGBPoint(at(0.0), 0.1, 0.2, 0.8);
  color->AddRGBPoint(at(0.35), 0.2, 0.9, 0.9);
  color->AddRGBPoint(at(1.0), 1.0, 0.3, 0.1);
  if (spiky)
  {
    for (const double middle : { 0.2, 0.5, 0.8 })
    {
      opacity->AddPoint(at(middle - 0.02), 0.0);
      opacity->AddPoint(at(middle), 5.0);
      opacity->AddPoint(at(middle + 0.02), 0.0);
    }
  }
  else
  {
    opacity->AddPoint(at(0.0), 0.02);
    opacity->AddPoint(at(0.3), 0.2);
    opacity->AddPoint(at(1.0), 1.0);
  }
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(diagonal / 20.0);
  property->SetInterpolationTypeToLinear();
}
}

//------------------------------------------------------------------------------
BenchmarkMesh LoadBenchmarkHexahedra(const std::string& folder)
{
  if (vtksys::SystemTools::FileExists(folder + "/bluntfinxyz.bin"))
  {
    return { "Blunt Fin", ReadBluntFin(folder) };
  }
  return { "generated curvilinear mesh", MakeCurvilinear() };
}

//------------------------------------------------------------------------------
BenchmarkMesh LoadBenchmarkMesh(const std::string& folder)
{
  const BenchmarkMesh hexahedra = LoadBenchmarkHexahedra(folder);
  return { hexahedra.Name, CutToTetrahedra(hexahedra.Grid) };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> ReadBuckyBall(const std::string& folder)
{
  constexpr int size = 32;
  vtkNew<vtkUnsignedCharArray> density;
  density->SetName("density");
  density->SetNumberOfValues(size * size * size);
  std::ifstream file(folder + "/Bucky.raw", std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(density->GetPointer(0)), size * size * size))
  {
    return nullptr;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, size);
  image->GetPointData()->SetScalars(density);
  return Unstructured(image);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> CutToTetrahedra(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(grid);
  cut->TetrahedraOnlyOn();
  cut->Update();
  return cut->GetOutput();
}

//------------------------------------------------------------------------------
BenchmarkScene::BenchmarkScene(
  vtkUnstructuredGridVolumeMapper* mapper, vtkUnstructuredGrid* grid, int size, bool spiky)
{
  mapper->SetInputData(grid);
  this->SetFunctionsFor(grid, spiky);
  this->Volume->SetMapper(mapper);
  this->Renderer->AddVolume(this->Volume);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(size, size);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->ResetCamera();
}

//------------------------------------------------------------------------------
void BenchmarkScene::SetFunctionsFor(vtkUnstructuredGrid* grid, bool spiky)
{
  double range[2];
  grid->GetScalarRange(range);
  SetProperty(this->Volume->GetProperty(), range, grid->GetLength(), spiky);
}

//------------------------------------------------------------------------------
void BenchmarkScene::MoveEye(int frame)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double* focus = camera->GetFocalPoint();
  const double distance = camera->GetDistance();
  const double angle = 0.7 + 0.1 * frame;
  camera->SetPosition(focus[0] + distance * std::cos(angle) * 0.8, focus[1] - 0.6 * distance,
    focus[2] + distance * std::sin(angle) * 0.8);
  camera->SetViewUp(0.0, 0.0, 1.0);
  this->Renderer->ResetCamera();
}

//------------------------------------------------------------------------------
double BenchmarkScene::TimeRender()
{
  const auto start = std::chrono::steady_clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

//------------------------------------------------------------------------------
double BenchmarkScene::TimeFrame(int frame)
{
  this->MoveEye(frame);
  return this->TimeRender();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> BenchmarkScene::ReadWindow()
{
  const int* size = this->Window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfComponents(4);
  for (vtkIdType id = 0; id < pixels->GetNumberOfTuples(); ++id)
  {
    const double* rgb = pixels->GetTuple3(id);
    values->InsertNextTuple4(rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0, 0.0);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->GetPointData()->SetScalars(values);
  return image;
}

//------------------------------------------------------------------------------
double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}
