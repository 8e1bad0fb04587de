// M5, M8: opaque geometry through cells hides what lies behind it, per pixel, in multisampled
// windows too; clipping planes cut per pixel, in world coordinates.

#include "OpaquePlane.h"
#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include "vtkCellType.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

namespace
{
void CheckOpaque(TestChecks& checks, const PolyhedraMappers::Entry& mapper, int samples)
{
  PolyhedraScene scene(mapper.Make());
  scene.Window->SetMultiSamples(samples);
  scene.SetMesh(PolyhedraMeshes::Hexahedra(3));
  OpaquePlane::AddSlanted(scene);
  scene.LookFrom(0.0, 0.0, 2.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.9);
  camera->SetClippingRange(1.0, 3.0);
  scene.Oracle->SetOpaqueDepth(OpaquePlane::DepthsOfSlanted(scene));
  const std::string name = mapper.Name + ", samples " + std::to_string(samples);
  const PolyhedraScene::Errors errors = scene.CompareWithOracle(name);
  // The z-buffer's own 24 bits are 1e-7 of the depth; a sample of a multisampled pixel lies up to
  // half a pixel away, .0014 of depth: twice that in emission, .01 in a scalar that falls from 1 to
  // 0 in .14.
  const double moved = scene.IsAdditive() ? 2.8e-3 : 1e-2;
  const double bound = samples == 0 ? scene.GetBound() : moved;
  checks.Check(errors.Compared >= 0.0 && errors.Compared <= bound, name.c_str(), __LINE__,
    std::to_string(errors.Compared));
  // It hides something.
  auto hidden = scene.CopyCaptured();
  scene.Renderer->RemoveAllViewProps();
  scene.Renderer->AddVolume(scene.Volume);
  scene.Render();
  CHECK(TestScene::Difference(hidden, scene.Mapper->GetCapturedImage()) > 0.05);
}

// On the ray through the centre, half of a cube of constant emission is before the plane.
void CheckHalf(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make());
  scene.SetMesh(TestMeshes::Cube(VTK_HEXAHEDRON));
  scene.SetConstant(1.0);
  OpaquePlane::AddSlanted(scene);
  scene.LookFrom(0.0, 0.0, 2.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.9);
  scene.Render();
  const double expected = scene.IsAdditive() ? 0.5 - 0.2 * 0.9 / 128.0 : 1.0;
  CHECK_NEAR(scene.CenterPixel()[0], expected, 1e-4);
}

void CheckClippingPlanes(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make(), 96, 96);
  scene.SetMesh(PolyhedraMeshes::Hexahedra(3));
  scene.Volume->RotateY(20.0);
  scene.Volume->SetScale(1.0, 1.2, 0.9);
  vtkNew<vtkPlaneCollection> collection;
  scene.Mapper->SetClippingPlanes(collection);
  scene.Oracle->SetClippingPlanes(collection);
  const double planes[3][6] = { { 0.1, 0.0, 0.0, 1.0, 0.3, 0.2 }, { 0.0, 0.2, 0.0, 0.0, -1.0, 0.1 },
    { 0.0, 0.0, -0.3, 0.2, 0.1, 2.0 } };
  for (const auto& numbers : planes)
  {
    scene.Render();
    auto before = scene.CopyCaptured();
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(numbers);
    plane->SetNormal(numbers + 3);
    collection->AddItem(plane);
    for (const int view : { 1, 2, 0 })
    {
      scene.SetView(view);
      const std::string name = mapper.Name + ", view " + std::to_string(view) + ", planes ";
      scene.CheckWithOracle(
        checks, name + std::to_string(collection->GetNumberOfItems()), __LINE__);
    }
    CHECK(TestScene::Difference(before, scene.Mapper->GetCapturedImage()) > 1e-2);
  }
}
}

int TestPolyhedraCuts(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    CheckHalf(checks, mapper);
  }
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
  {
    CheckOpaque(checks, mapper, 0);
    CheckOpaque(checks, mapper, 4);
    CheckClippingPlanes(checks, mapper);
  }
  return checks.Result();
}
