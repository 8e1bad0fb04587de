// M2: lengths are those of the world: the same slab under any actor matrix has alpha 1 - exp(-1).

#include "TestMeshes.h"
#include "TestScene.h"

#include <cmath>

int TestActorScale(int, char*[])
{
  TestChecks checks;
  TestScene scene;
  const double expected = 1.0 - std::exp(-1.0);
  const int cells[3] = { 2, 2, 2 };
  for (const double scale : { 0.1, 1.0, 3.0, 10.0 })
  {
    const double size[3] = { 1.0 / scale, 1.0 / scale, 1.0 / scale };
    scene.SetGrid(TestMeshes::Slab(size, cells));
    scene.SetConstant(1.0);
    scene.Volume->SetScale(scale);
    scene.LookFrom(0.0, 0.0, 2.2);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Render();
    CHECK_NEAR(scene.CenterPixel()[3], expected, 1e-5);
  }
  // Not the same along every axis, turned, moved: against the oracle too.
  const double size[3] = { 1.0, 0.5, 0.25 };
  auto slab = TestMeshes::Slab(size, cells);
  TestMeshes::SetField(slab, [](const double* p) { return 0.5 + p[0]; });
  scene.SetGrid(slab);
  scene.SetSmooth();
  scene.Volume->SetScale(1.0, 2.0, 4.0);
  scene.Volume->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  scene.Volume->SetPosition(0.2, -0.1, 0.3);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  const double error = scene.MaximumError("scaled, turned, moved");
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 1e-4);
  return checks.Result();
}
