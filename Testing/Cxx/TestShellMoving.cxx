// Moving points: the image is a fresh mapper's, points alone are sent to the GPU, cells that turn
// inside out are counted and drawn, and five hundred frames take no more memory than fifty, in
// shells and for lit iso-surfaces.

#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"

#include "vtkContourValues.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <vector>

namespace
{
void Bend(vtkUnstructuredGrid* grid, vtkPoints* rest, double amount)
{
  for (vtkIdType id = 0; id < rest->GetNumberOfPoints(); ++id)
  {
    double p[3];
    rest->GetPoint(id, p);
    grid->GetPoints()->SetPoint(
      id, p[0] + amount * std::sin(3.0 * p[1]), p[1], p[2] + amount * p[0] * p[0]);
  }
  grid->GetPoints()->Modified();
}

double DifferenceToFresh(TestScene& scene)
{
  auto kept = scene.CopyCaptured();
  vtkNew<vtkBarycentricShellMapper> fresh;
  fresh->SetInputData(scene.Mapper->GetInput());
  fresh->CaptureImageOn();
  scene.Volume->SetMapper(fresh);
  scene.Render();
  const double difference = TestScene::Difference(kept, fresh->GetCapturedImage());
  scene.Volume->SetMapper(scene.Mapper);
  return difference;
}

void CheckUploads(TestChecks& checks)
{
  TestScene scene(vtkNew<vtkBarycentricShellMapper>(), 64, 64);
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  auto grid = TestMeshes::JitteredCube(3);
  vtkNew<vtkPoints> rest;
  rest->DeepCopy(grid->GetPoints());
  const vtkIdType points = grid->GetNumberOfPoints();
  scene.SetGrid(grid);
  scene.Render();
  CHECK(mapper->GetUploadedBytes() == 20 * points);
  auto still = scene.CopyCaptured();
  scene.Render();
  CHECK(mapper->GetUploadedBytes() == 0);
  for (const double amount : { 0.1, 0.3 })
  {
    Bend(grid, rest, amount);
    scene.Render();
    CHECK(mapper->GetUploadedBytes() == 16 * points);
    CHECK(TestScene::Difference(still, mapper->GetCapturedImage()) > 1e-2);
    CHECK(DifferenceToFresh(scene) == 0.0);
  }
  // Points in an object of their own, as a filter upstream makes them.
  vtkNew<vtkPoints> other;
  other->DeepCopy(rest);
  grid->SetPoints(other);
  scene.Render();
  CHECK(mapper->GetUploadedBytes() == 16 * points);
  CHECK(TestScene::Difference(still, mapper->GetCapturedImage()) == 0.0);
  TestMeshes::SetField(grid, [](const double* p) { return p[0] + 0.5; });
  scene.Render();
  CHECK(mapper->GetUploadedBytes() == 4 * points);
  CHECK(DifferenceToFresh(scene) == 0.0);
}

// One corner of six tetrahedra goes through the opposite one: some turn inside out.
void CheckTurned(TestChecks& checks)
{
  TestScene scene(vtkNew<vtkBarycentricShellMapper>(), 64, 64);
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  vtkNew<MessageObserver> messages;
  messages->Watch(mapper);
  auto grid = TestMeshes::Tetrahedron();
  scene.SetGrid(grid);
  scene.SetConstant(1.0);
  scene.Render();
  CHECK(mapper->GetNumberOfTurnedCells() == 0);
  grid->GetPoints()->SetPoint(3, 0.05, 0.1, -1.0);
  grid->GetPoints()->Modified();
  scene.Render();
  CHECK(mapper->GetNumberOfTurnedCells() == 1);
  CHECK(messages->CountOf("1 tetrahedra inside out") == 1);
  CHECK(scene.MaximumError("turned inside out") >= 0.0);
  CHECK_AT_MOST(scene.Oracle->GetMaximumError(), 1e-3);
  // A corner that goes to where there are no numbers takes its cell along, the rest stays.
  auto cube = TestMeshes::SixTetrahedra();
  scene.SetGrid(cube);
  scene.Render();
  cube->GetPoints()->SetPoint(1, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  cube->GetPoints()->Modified();
  scene.Render();
  CHECK(scene.CenterPixel()[3] > 0.1);
}

// Of this process in pages; 0 where the system does not say.
long ResidentPages()
{
  long all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident;
}

void CheckMemory(TestChecks& checks, bool asSurfaces)
{
  TestScene scene(vtkNew<vtkBarycentricShellMapper>(), 24, 24);
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  mapper->CaptureImageOff();
  mapper->SetSamplesPerRay(24.0);
  auto grid = TestMeshes::JitteredCube(6);
  vtkNew<vtkPoints> rest;
  rest->DeepCopy(grid->GetPoints());
  scene.SetGrid(grid);
  if (asSurfaces)
  {
    mapper->SetBlendModeToIsoSurface();
    scene.SetConstant(1.0);
    scene.Property->GetIsoSurfaceValues()->SetValue(0, 0.5);
    scene.Property->ShadeOn();
  }
  std::vector<long> growths;
  long before = 0;
  for (int frame = 0; frame <= 550; ++frame)
  {
    Bend(grid, rest, 0.1 * std::sin(0.1 * frame));
    scene.Render();
    if (frame % 50 == 0)
    {
      const long now = ResidentPages();
      growths.push_back(now - before);
      std::cout << "frame " << frame << ": " << growths.back() << " pages more than " << before << "\n";
      before = now;
    }
  }
  CHECK(asSurfaces == (mapper->GetNumberOfShells() == 0));
  // One point buffer a frame, 5,488 bytes, would be 60 pages in every fifty frames. Pools of the
  // driver grow in few of them.
  const auto middle = growths.begin() + 7;
  std::nth_element(growths.begin() + 2, middle, growths.end());
  CHECK_AT_MOST(*middle, 15);
}
}

int TestShellMoving(int, char*[])
{
  TestChecks checks;
  CheckUploads(checks);
  CheckTurned(checks);
  CheckMemory(checks, false);
  CheckMemory(checks, true);
  return checks.Result();
}
