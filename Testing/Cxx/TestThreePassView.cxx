// Three passes draw what one pass does: with the eye in a cell that is behind the near plane as a
// whole, and where the volume, the camera or both mirror the mesh.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"

#include "vtkProjectedPolyhedraMapper.h"
#include "vtkTransform.h"

namespace
{
// The trapezoid rule's error at this mesh and these functions.
constexpr double Bound = 1e-2;

class Pair
{
public:
  explicit Pair(vtkUnstructuredGrid* grid)
    : Scene(vtkSmartPointer<vtkProjectedPolyhedraMapper>::New(), 64, 64)
  {
    this->Scene.SetMesh(grid);
  }
  double Difference()
  {
    auto* mapper = vtkProjectedPolyhedraMapper::SafeDownCast(this->Scene.Mapper);
    mapper->SetPassesToOne();
    this->Scene.Render();
    auto one = this->Scene.CopyCaptured();
    this->LitPixels = this->Scene.CountLitPixels();
    mapper->SetPassesToThree();
    this->Scene.Render();
    return TestScene::Difference(one, mapper->GetCapturedImage());
  }

  PolyhedraScene Scene;
  int LitPixels = 0;
};

void CheckNearPlanes(TestChecks& checks, vtkUnstructuredGrid* grid)
{
  Pair pair(grid);
  pair.Scene.SetView(2);
  for (const double nearPlane : { 0.01, 0.1, 0.2, 0.3 })
  {
    pair.Scene.Renderer->GetActiveCamera()->SetClippingRange(nearPlane, 10.0);
    CHECK_AT_MOST(pair.Difference(), Bound);
    CHECK(pair.LitPixels == 64 * 64);
  }
}

void CheckMirrors(TestChecks& checks, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkTransform> mirror;
  mirror->Scale(-1.0, 1.0, 1.0);
  for (const bool mirrorsVolume : { false, true })
  {
    for (const bool mirrorsCamera : { false, true })
    {
      Pair pair(grid);
      // From within: no silhouettes, which the rasteriser decides in three passes.
      pair.Scene.SetView(2);
      pair.Scene.Volume->SetScale(mirrorsVolume ? -1.0 : 1.0, 1.0, 1.0);
      if (mirrorsCamera)
      {
        pair.Scene.Renderer->GetActiveCamera()->SetUserTransform(mirror);
      }
      CHECK_AT_MOST(pair.Difference(), Bound);
      CHECK(pair.LitPixels == 64 * 64);
    }
  }
}
}

int TestThreePassView(int, char*[])
{
  TestChecks checks;
  auto grid = PolyhedraMeshes::Hexahedra(16);
  PolyhedraMeshes::SetWaves(grid);
  CheckNearPlanes(checks, grid);
  CheckMirrors(checks, grid);
  return checks.Result();
}
