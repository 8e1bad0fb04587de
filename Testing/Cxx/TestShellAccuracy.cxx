// Against the oracle: with points the error falls in proportion to the distance between samples,
// with pre-integration to its square; 600 samples along a ray are enough, and 1200 points where the
// function is four times as dense.

#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"
#include "vtkConvexCells.h"

#include <cmath>

namespace
{
void SetCut(TestScene& scene, vtkUnstructuredGrid* grid)
{
  // The oracle sees the tetrahedra that are drawn.
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(grid);
  cut->TetrahedraOnlyOn();
  cut->Update();
  scene.SetGrid(cut->GetOutput());
}

enum class Measure
{
  RootMeanSquare,
  Percentile
};

// The error over each of four distances, each half of the last: the mean ratio of two in a row.
double MeanRatio(TestChecks& checks, TestScene& scene, const std::string& name, double coarsest,
  Measure measure = Measure::RootMeanSquare)
{
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  double first = 0.0, last = 0.0;
  for (const double finer : { 1.0, 2.0, 4.0, 8.0 })
  {
    mapper->SetSamplesPerRay(finer * coarsest);
    CHECK(scene.MaximumError(name + ", " + std::to_string(mapper->GetSamplesPerRay())) >= 0.0);
    last = measure == Measure::RootMeanSquare ? scene.Oracle->GetRootMeanSquareError()
                                              : scene.Oracle->GetPercentileError();
    first = first == 0.0 ? last : first;
  }
  return std::cbrt(first / last);
}

void CheckMesh(TestChecks& checks, TestScene& scene, const std::string& name, Measure measure)
{
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  mapper->SetIntegrationToPoint();
  const double point = MeanRatio(checks, scene, name + ", point", 75.0);
  // From inside, where all rays begin at one distance, all errors have one phase.
  CHECK_NEAR(point, 2.0, 0.3);
  CHECK_AT_MOST(scene.Oracle->GetRootMeanSquareError(), 1e-3);
  CHECK_AT_MOST(scene.Oracle->GetMaximumError(), 1e-2);
  mapper->SetIntegrationToPreIntegrated();
  const double slab = MeanRatio(checks, scene, name + ", pre-integrated", 25.0, measure);
  std::cout << name << ": ratios " << point << " and " << slab << "\n";
  CHECK_NEAR(slab, 4.0, 0.4);
}

// The smooth function of the report: opacity that rises to 1 over a twentieth of the diagonal. Up to
// a sixtieth of an optical depth is lost or won where a ray begins or ends between two of 600 points:
// the sum over the same slices in double has an RMSE of 1.1e-3 (cube) and 1.5e-3, and errors up to
// 1.4e-2. With twice as many points the bounds hold.
void CheckReportFunction(TestChecks& checks, TestScene& scene, const std::string& name)
{
  scene.SetReportSmooth(vtkUnstructuredGrid::SafeDownCast(scene.Mapper->GetInput()));
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  const auto check = [&](const char* integration, double samples, double share)
  {
    mapper->SetSamplesPerRay(samples);
    CHECK(scene.MaximumError(name + ", " + integration) >= 0.0);
    CHECK_AT_MOST(scene.Oracle->GetRootMeanSquareError(), share * 1e-3);
    CHECK_AT_MOST(scene.Oracle->GetMaximumError(), share * 1e-2);
  };
  mapper->SetIntegrationToPoint();
  check("600 points", 600.0, 1.65);
  check("1200 points", 1200.0, 1.0);
  mapper->SetIntegrationToPreIntegrated();
  check("600 pre-integrated", 600.0, 0.1);
}
}

int TestShellAccuracy(int, char*[])
{
  TestChecks checks;
  TestScene scene(vtkNew<vtkBarycentricShellMapper>(), 64, 64);
  SetCut(scene, TestMeshes::JitteredCube(5));
  CheckMesh(checks, scene, "cube", Measure::RootMeanSquare);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.9);
  CheckMesh(checks, scene, "cube, parallel", Measure::RootMeanSquare);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  scene.LookFrom(0.1, 0.05, 0.15);
  CheckMesh(checks, scene, "cube, from inside", Measure::RootMeanSquare);
  // A few rays leave this one through a dent and enter it again within two slices.
  SetCut(scene, TestMeshes::Curvilinear(5));
  scene.LookFrom(0.5, 0.8, 2.2);
  CheckMesh(checks, scene, "curvilinear", Measure::Percentile);
  CheckReportFunction(checks, scene, "the report's function, curvilinear");
  SetCut(scene, TestMeshes::JitteredCube(5));
  CheckReportFunction(checks, scene, "the report's function, cube");
  return checks.Result();
}
