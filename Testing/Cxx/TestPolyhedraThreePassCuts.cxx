// Three passes where planes cut cells. At the near plane, caps have the scalar of the cut: exact in
// a linear field with a linear emission, the camera inside the mesh or not. At the far plane and at
// clipping planes lengths are exact and ends keep the emission of the whole cell.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProjectedPolyhedraMapper.h"

namespace
{
vtkSmartPointer<vtkProjectedPolyhedraMapper> MakeMapper()
{
  auto mapper = vtkSmartPointer<vtkProjectedPolyhedraMapper>::New();
  mapper->SetPassesToThree();
  return mapper;
}

// Cells that the near plane cuts are closed by caps.
void CheckNearPlane(TestChecks& checks, const PolyhedraMeshes::Entry& mesh)
{
  PolyhedraMeshes::SetLinear(mesh.Mesh);
  PolyhedraScene scene(MakeMapper(), 64, 64);
  scene.SetMesh(mesh.Mesh);
  scene.SetLinearEmission();
  const double planes[5][2] = { { 2, 1e-3 }, { 2, 0.1 }, { 2, 0.25 }, { 0, 1.9 }, { 1, 2.0 } };
  for (const auto& plane : planes)
  {
    scene.SetView(static_cast<int>(plane[0]));
    scene.Renderer->GetActiveCamera()->SetClippingRange(plane[1], 10.0);
    scene.CheckMostPixels(
      checks, mesh.Name + ", three passes, near plane at " + std::to_string(plane[1]), __LINE__);
  }
}

// Cut at a clipping plane or the far plane, a cell has the right length and the emission of its
// whole self: off by half of that length times the change of emission, in one cell per plane.
void CheckOtherCuts(TestChecks& checks)
{
  PolyhedraScene scene(MakeMapper(), 64, 64);
  auto grid = PolyhedraMeshes::Hexahedra(16);
  PolyhedraMeshes::SetLinear(grid);
  scene.SetMesh(grid);
  scene.SetLinearEmission();
  // A cell is at most .13 across; along that the scalar changes by .13 and the emission by .19.
  const double bound = 0.5 * 0.13 * 0.19;
  scene.SetView(0);
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.1, 2.0);
  const PolyhedraScene::Errors farErrors = scene.CompareWithOracle("three passes, far plane");
  CHECK(farErrors.Compared >= 0.0);
  CHECK_AT_MOST(farErrors.Compared, bound);
  scene.SetView(1);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.5, 0.2);
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  scene.Mapper->SetClippingPlanes(planes);
  scene.Oracle->SetClippingPlanes(planes);
  const PolyhedraScene::Errors errors = scene.CompareWithOracle("three passes, clipping plane");
  CHECK(errors.Compared >= 0.0);
  CHECK_AT_MOST(errors.Compared, bound);
}
}

int TestPolyhedraThreePassCuts(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMeshes::Entry& mesh : PolyhedraMeshes::All())
  {
    CheckNearPlane(checks, mesh);
  }
  CheckOtherCuts(checks);
  return checks.Result();
}
