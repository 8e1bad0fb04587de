// M2 and hard coordinates: lengths are those of the world, whatever the volume's matrix; meshes at
// 1e7 and of 1e-7, scaled differently along every axis, mirrored, and slivers.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include <cmath>

namespace
{
void CheckLengths(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  const int cells[3] = { 2, 2, 2 };
  for (const double scale : { 0.1, 1.0, 3.0, 10.0 })
  {
    PolyhedraScene scene(mapper.Make());
    const double size[3] = { 1.0 / scale, 1.0 / scale, 1.0 / scale };
    scene.SetMesh(TestMeshes::Slab(size, cells));
    scene.SetConstant(1.0);
    scene.Volume->SetScale(scale);
    scene.LookFrom(0.0, 0.0, 2.2);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Render();
    CHECK_NEAR(scene.CenterPixel()[0], 1.0, 1e-5);
  }
}

void CheckMatrices(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make(), 96, 96);
  scene.SetMesh(PolyhedraMeshes::Hexahedra(3));
  const double scales[3][3] = { { 0.5, 1.0, 2.0 }, { 1.0, 0.05, 1.0 }, { -1.0, 1.2, 0.8 } };
  for (const auto& scale : scales)
  {
    scene.Volume->SetScale(scale[0], scale[1], scale[2]);
    scene.Volume->SetOrientation(0.0, 0.0, 0.0);
    scene.Volume->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
    scene.Volume->SetPosition(0.1, -0.1, 0.2);
    for (int view = 0; view < PolyhedraScene::NumberOfViews; ++view)
    {
      scene.SetView(view);
      const std::string name = mapper.Name + ", scaled by " + std::to_string(scale[0]) + " " +
                               std::to_string(scale[1]) + " " + std::to_string(scale[2]);
      scene.CheckWithOracle(checks, name + ", view " + std::to_string(view), __LINE__);
    }
  }
}

// The view of view 0, of a mesh that was moved and scaled.
void CheckPlace(
  TestChecks& checks, const PolyhedraMappers::Entry& mapper, double offset, double scale)
{
  PolyhedraScene scene(mapper.Make(), 96, 96);
  auto grid = TestMeshes::Curvilinear(4);
  PolyhedraMeshes::SetWaves(grid);
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double p[3];
    grid->GetPoint(id, p);
    grid->GetPoints()->SetPoint(
      id, offset + scale * p[0], offset + scale * p[1], scale * p[2] - offset);
  }
  scene.SetMesh(grid);
  scene.Property->SetScalarOpacityUnitDistance(scene.IsAdditive() ? scale : 1.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(offset, offset, -offset);
  camera->SetPosition(offset + 0.5 * scale, offset + 0.8 * scale, 2.2 * scale - offset);
  camera->SetClippingRange(0.1 * scale, 20.0 * scale);
  const std::string name =
    mapper.Name + " at " + std::to_string(offset) + ", of " + std::to_string(1e9 * scale) + "e-9";
  scene.CheckWithOracle(checks, name, __LINE__);
}

void CheckSlivers(TestChecks& checks, const PolyhedraMappers::Entry& mapper, double thickness)
{
  PolyhedraScene scene(mapper.Make(), 96, 96);
  auto grid = PolyhedraMeshes::Hexahedra(2);
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double p[3];
    grid->GetPoint(id, p);
    grid->GetPoints()->SetPoint(id, p[0], p[1] * thickness, p[2]);
  }
  scene.SetMesh(grid);
  scene.Property->SetScalarOpacityUnitDistance(scene.IsAdditive() ? thickness : 1.0);
  scene.LookFrom(0.4, 2.0, 0.7);
  scene.Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  const std::string name = mapper.Name + ", slivers of " + std::to_string(thickness);
  scene.CheckWithOracle(checks, name, __LINE__);
}
}

int TestPolyhedraScales(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    if (PolyhedraScene(mapper.Make()).IsAdditive())
    {
      CheckLengths(checks, mapper);
    }
  }
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
  {
    CheckMatrices(checks, mapper);
    CheckPlace(checks, mapper, 1e7, 1.0);
    CheckPlace(checks, mapper, 1e7, 1e4);
    CheckPlace(checks, mapper, 0.0, 1e-7);
    CheckPlace(checks, mapper, 0.0, 1e12);
    for (const double thickness : { 1e-1, 1e-2, 1e-4 })
    {
      CheckSlivers(checks, mapper, thickness);
    }
  }
  return checks.Result();
}
