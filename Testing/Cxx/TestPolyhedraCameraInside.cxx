// M4: with the camera inside the mesh every pixel is lit and exact, wherever the near plane cuts;
// near, far and both planes through a mesh that is seen from outside.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"

namespace
{
void CheckNearPlanes(TestChecks& checks, PolyhedraScene& scene, const std::string& name)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  scene.SetView(2);
  const int* size = scene.Renderer->GetSize();
  for (const double nearPlane : { 1e-15, 1e-9, 1e-3, 0.1, 0.25 })
  {
    camera->SetClippingRange(nearPlane, 10.0);
    scene.CheckWithOracle(checks, name + ", near plane at " + std::to_string(nearPlane), __LINE__);
    CHECK(scene.CountLitPixels() == size[0] * size[1]);
  }
  scene.LookFrom(0.3, 0.4, 2.0);
  const double ranges[3][2] = { { 1.9, 20.0 }, { 1.9, 2.2 }, { 0.1, 2.1 } };
  for (const auto& range : ranges)
  {
    camera->SetClippingRange(range[0], range[1]);
    scene.CheckWithOracle(checks,
      name + ", clipped from " + std::to_string(range[0]) + " to " + std::to_string(range[1]),
      __LINE__);
  }
}
}

int TestPolyhedraCameraInside(int, char*[])
{
  TestChecks checks;
  const PolyhedraMeshes::Entry meshes[3] = { { "curvilinear", TestMeshes::Curvilinear(4) },
    { "hexahedra", PolyhedraMeshes::Hexahedra(3) },
    { "polyhedra", PolyhedraMeshes::TruncatedOctahedra(3) } };
  for (const PolyhedraMeshes::Entry& mesh : meshes)
  {
    PolyhedraMeshes::SetWaves(mesh.Mesh);
    for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
    {
      PolyhedraScene scene(mapper.Make(), 96, 96);
      scene.SetMesh(mesh.Mesh);
      CheckNearPlanes(checks, scene, mesh.Name + ", " + mapper.Name);
    }
  }
  return checks.Result();
}
