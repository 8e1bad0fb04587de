// Every mesh that is hard to sort, cut into tetrahedra, by the Tiles engine with no sort and
// nothing filled in: within 1e-4 of the oracle, cells that hide each other in a circle included.

#include "SortMeshes.h"
#include "SortTesting.h"
#include "TilesScene.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{
// Looks at all of the mesh, from the eye.
void LookFrom(TilesScene& scene, vtkUnstructuredGrid* grid, SortTesting::Eye eye)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  SortTesting::SetCamera(camera, grid, eye);
  double bounds[6];
  grid->GetBounds(bounds);
  if (eye.Position[3] == 0.0)
  {
    double place[2][3];
    for (int i = 0; i < 3; ++i)
    {
      place[0][i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
      place[1][i] = place[0][i] + 2.0 * grid->GetLength() * eye.Position[i];
    }
    camera->SetFocalPoint(place[0]);
    camera->SetPosition(place[1]);
    camera->SetParallelScale(0.6 * grid->GetLength());
  }
  scene.Renderer->ResetCameraClippingRange(bounds);
}

// Returns how many views saw something.
int CheckMesh(TestChecks& checks, TilesScene& scene, const SortMeshes::Entry& entry)
{
  int views = 0;
  auto tetrahedra = SortMeshes::Tetrahedra(SortMeshes::Make(entry.Name));
  SortMeshes::AddScalar(tetrahedra);
  scene.SetTetrahedra(tetrahedra);
  // Opaque enough for an order to matter, whatever the mesh's size.
  scene.Property->SetScalarOpacityUnitDistance(0.1 * tetrahedra->GetLength());
  std::vector<SortTesting::Eye> eyes = SortTesting::FewEyes(tetrahedra);
  eyes.push_back(SortTesting::EyeUp(tetrahedra, false));
  for (const SortTesting::Eye& eye : eyes)
  {
    LookFrom(scene, tetrahedra, eye);
    const double error = scene.TilesError(entry.Name + ", " + eye.Name);
    // From within one sees nothing of some: then neither image has a colour.
    CHECK(error >= 0.0 || scene.Oracle->GetNumberOfCoveredPixels() == 0);
    views += error >= 0.0 ? 1 : 0;
    checks.Check(
      error <= 1e-4, (entry.Name + ", " + eye.Name).c_str(), __LINE__, std::to_string(error));
  }
  return views;
}
}

int TestTilesHardMeshes(int argc, char* argv[])
{
  TestChecks checks;
  const std::string only = argc > 1 && argv[1][0] != '-' ? argv[1] : "";
  TilesScene scene(40, 36);
  scene.SetSpiky();
  for (const auto& entry : SortMeshes::All())
  {
    if (only.empty() || only == entry.Name)
    {
      CHECK(CheckMesh(checks, scene, entry) >= 4);
    }
  }
  return checks.Result();
}
