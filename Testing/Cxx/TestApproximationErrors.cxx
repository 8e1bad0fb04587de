// What each approximation loses: its error against the oracle on two transfer functions, and how
// near Shirley's and Tuchman's come to VTK's own projected tetrahedra.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkConvexCells.h"
#include "vtkMPVOVisibilitySort.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace
{
using Mapper = vtkPreIntegratedTetrahedraMapper;

struct Bounds
{
  int Approximation;
  const char* Name;
  /// Root of the mean square, least and greatest: an error below the least would be another method.
  double Smooth[2];
  double Spiky[2];
};

void CheckErrors(TestChecks& checks, bool spiky)
{
  const Bounds all[] = {
    { Mapper::SHIRLEY_TUCHMAN, "ShirleyTuchman", { 0.015, 0.025 }, { 0.08, 0.11 } },
    { Mapper::SHIRLEY_TUCHMAN_EXPONENTIAL, "ShirleyTuchmanExponential", { 0.010, 0.017 }, { 0.08, 0.105 } },
    { Mapper::VOXEL, "Voxel", { 0.05, 0.07 }, { 0.11, 0.15 } },
    { Mapper::UNIFORM_THICKNESS_1, "UniformThickness1", { 0.05, 0.07 }, { 0.09, 0.125 } },
    { Mapper::UNIFORM_THICKNESS_2, "UniformThickness2", { 0.05, 0.07 }, { 0.09, 0.125 } },
    { Mapper::CENTROID, "Centroid", { 0.05, 0.07 }, { 0.085, 0.12 } },
  };
  TestScene scene(64, 64);
  scene.SetGrid(TestMeshes::Delaunay(1000));
  if (spiky)
  {
    scene.SetSpiky();
  }
  for (const Bounds& bounds : all)
  {
    scene.GetTetrahedraMapper()->SetApproximation(bounds.Approximation);
    const double maximum = scene.MaximumError(bounds.Name);
    const double (&limits)[2] = spiky ? bounds.Spiky : bounds.Smooth;
    const double error = scene.Oracle->GetRootMeanSquareError();
    CHECK(maximum >= 0.0);
    checks.Check(error >= limits[0] && error <= limits[1], bounds.Name, __LINE__,
      std::to_string(error));
  }
}

// VTK's window over black; its colours are not alone in a float image.
std::vector<double> DrawByVTK(TestScene& scene, vtkUnstructuredGrid* grid)
{
  auto theirs = vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
  vtkNew<vtkMPVOVisibilitySort> sort;
  theirs->SetInputData(grid);
  theirs->SetVisibilitySort(sort);
  scene.Volume->SetMapper(theirs);
  // A part of its first frame is missing.
  scene.Render();
  scene.Render();
  const int* size = scene.Window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  scene.Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  std::vector<double> values;
  for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
  {
    values.push_back(pixels->GetValue(i) / 255.0);
  }
  scene.Volume->SetMapper(scene.Mapper);
  return values;
}

void CompareWithVTK(TestChecks& checks)
{
  TestScene scene;
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(TestMeshes::Curvilinear(6));
  cut->TetrahedraOnlyOn();
  cut->Update();
  scene.SetGrid(cut->GetOutput());
  // VTK's mapper has no opacity above 1.
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.05);
  scene.Opacity->AddPoint(1.0, 1.0);
  scene.Property->SetScalarOpacityUnitDistance(0.5);
  const std::vector<double> theirs = DrawByVTK(scene, cut->GetOutput());
  for (const int approximation : { Mapper::SHIRLEY_TUCHMAN, Mapper::SHIRLEY_TUCHMAN_EXPONENTIAL })
  {
    scene.GetTetrahedraMapper()->SetApproximation(approximation);
    scene.Render();
    double sum = 0.0, largest = 0.0;
    for (int i = 0; i < 128 * 128; ++i)
    {
      const std::array<double, 4> ours = scene.Pixel(i % 128, i / 128);
      for (int channel = 0; channel < 3; ++channel)
      {
        const double difference = ours[channel] - theirs[3 * static_cast<size_t>(i) + channel];
        sum += difference * difference;
        largest = std::max(largest, std::abs(difference));
      }
    }
    const double rms = std::sqrt(sum / (3.0 * 128 * 128));
    std::cout << "approximation " << approximation << " and VTK differ by RMS " << rms
              << ", at most " << largest << "\n";
    CHECK_AT_MOST(rms, approximation == Mapper::SHIRLEY_TUCHMAN ? 1.5e-2 : 4e-3);
  }
}
}

int TestApproximationErrors(int, char*[])
{
  TestChecks checks;
  CheckErrors(checks, false);
  CheckErrors(checks, true);
  CompareWithVTK(checks);
  return checks.Result();
}
