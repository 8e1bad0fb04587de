// Three passes: per cell the trapezoid rule, mean of the emission g at entry and exit times the
// length. Exact where g is linear in the scalar; else off by length * d^2 / 12 * g'' in a cell
// along which the scalar changes by d. One pass with AverageEmission is the same rule with exact
// lengths.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProjectedPolyhedraMapper.h"

#include <cmath>

namespace
{
vtkSmartPointer<vtkProjectedPolyhedraMapper> MakeMapper(int passes, bool average)
{
  auto mapper = vtkSmartPointer<vtkProjectedPolyhedraMapper>::New();
  mapper->SetPasses(passes);
  mapper->SetAverageEmission(average);
  return mapper;
}

// One colour, extinction linear in the scalar: so is the emission.
void SetLinearEmission(PolyhedraScene& scene)
{
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(0.0, 0.9, 0.5, 0.2);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.2);
  scene.Opacity->AddPoint(1.0, 1.8);
}

// Every pixel within 1e-4 but for two of a thousand.
void CheckScene(TestChecks& checks, PolyhedraScene& scene, const std::string& name, int line)
{
  const PolyhedraScene::Errors errors = scene.CompareWithOracle(name);
  const bool good = errors.Compared >= 0.0 && errors.WrongPixels <= 0.002 * errors.CoveredPixels;
  checks.Check(good, name.c_str(), line,
    std::to_string(errors.WrongPixels) + " pixels, by up to " + std::to_string(errors.Compared));
}

void CheckLinearEmission(TestChecks& checks, const PolyhedraMeshes::Entry& mesh, int passes)
{
  PolyhedraScene scene(MakeMapper(passes, true), 64, 64);
  scene.SetMesh(mesh.Mesh);
  SetLinearEmission(scene);
  for (const int view : { 0, 1 })
  {
    scene.SetView(view);
    const std::string name =
      mesh.Name + ", linear emission, passes " + std::to_string(passes) + ", view ";
    CheckScene(checks, scene, name + std::to_string(view), __LINE__);
  }
}

// Any emission: one pass with the mean is the same rule.
void CheckAgainstOnePass(TestChecks& checks, const PolyhedraMeshes::Entry& mesh)
{
  for (const int view : { 0, 1 })
  {
    PolyhedraScene three(MakeMapper(3, false)), one(MakeMapper(1, true));
    for (PolyhedraScene* scene : { &three, &one })
    {
      scene->SetMesh(mesh.Mesh);
      scene->SetView(view);
      scene->Render();
    }
    const int lit = three.CountLitPixels();
    const int different =
      TestScene::CountDifferent(one.CopyCaptured(), three.Mapper->GetCapturedImage(), 1e-4);
    std::cout << mesh.Name << ", view " << view << ": one pass with the mean differs from three in "
              << different << " of " << lit << " pixels\n";
    CHECK(lit > 1000);
    CHECK_AT_MOST(different, 0.002 * lit);
  }
}

// g = 2 s^2 along N cells of a unit cube whose scalar goes from 0 to 1: 2/3 + 1/(3 N^2).
void CheckTrapezoidRule(TestChecks& checks, int passes)
{
  for (const int cells : { 1, 2, 4, 8, 16 })
  {
    PolyhedraScene scene(MakeMapper(passes, true));
    const double size[3] = { 1.0, 1.0, 1.0 };
    const int counts[3] = { cells, 3, 3 };
    auto slab = TestMeshes::Slab(size, counts);
    TestMeshes::SetField(slab, [](const double* p) { return p[0] + 0.5; });
    scene.SetMesh(slab);
    scene.Color->RemoveAllPoints();
    scene.Color->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
    scene.Color->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
    scene.Opacity->RemoveAllPoints();
    scene.Opacity->AddPoint(0.0, 0.0);
    scene.Opacity->AddPoint(1.0, 2.0);
    scene.LookFrom(3.0, 0.0, 0.0);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Render();
    const double expected = 2.0 / 3.0 + 1.0 / (3.0 * cells * cells);
    CHECK_NEAR(scene.CenterPixel()[0], expected, 1e-5);
    CHECK(scene.CenterPixel()[3] == 0.0);
  }
}

// Halving cells quarters the error; the exact mapper does not care.
void CheckConvergence(TestChecks& checks)
{
  double before = 0.0;
  for (const int cells : { 4, 8, 16 })
  {
    PolyhedraScene scene(MakeMapper(3, false), 64, 64);
    auto grid = PolyhedraMeshes::Hexahedra(cells);
    PolyhedraMeshes::SetLinear(grid);
    scene.SetMesh(grid);
    scene.Color->RemoveAllPoints();
    scene.Color->AddRGBPoint(0.0, 0.1, 0.2, 0.9);
    scene.Color->AddRGBPoint(1.0, 0.9, 0.1, 0.1);
    // g'' is 2 c' kappa' <= 2 * .8 * 1.9 = 3.1; a cell's scalar changes by d = 1.5 / cells at most,
    // no ray is longer than 1.8 in the mesh.
    const double bound = 1.8 * 3.1 / 12.0 * 2.25 / (cells * cells);
    const PolyhedraScene::Errors errors = scene.CompareWithOracle("cells " + std::to_string(cells));
    CHECK(errors.Compared >= 0.0);
    CHECK_AT_MOST(errors.Compared, bound);
    CHECK(before == 0.0 || errors.Compared < 0.35 * before);
    before = errors.Compared;
  }
}

// Cells that the near plane cuts are closed by caps.
void CheckNearPlane(TestChecks& checks, const PolyhedraMeshes::Entry& mesh)
{
  PolyhedraMeshes::SetLinear(mesh.Mesh);
  PolyhedraScene scene(MakeMapper(3, false), 64, 64);
  scene.SetMesh(mesh.Mesh);
  SetLinearEmission(scene);
  const double planes[5][2] = { { 2, 1e-3 }, { 2, 0.1 }, { 2, 0.25 }, { 0, 1.9 }, { 1, 2.0 } };
  for (const auto& plane : planes)
  {
    scene.SetView(static_cast<int>(plane[0]));
    scene.Renderer->GetActiveCamera()->SetClippingRange(plane[1], 10.0);
    CheckScene(checks, scene,
      mesh.Name + ", three passes, near plane at " + std::to_string(plane[1]), __LINE__);
  }
}

// Cut at a clipping plane or the far plane, a cell has the right length and the emission of its
// whole self: off by half of that length times the change of emission, in one cell per plane.
void CheckOtherCuts(TestChecks& checks)
{
  PolyhedraScene scene(MakeMapper(3, false), 64, 64);
  auto grid = PolyhedraMeshes::Hexahedra(16);
  PolyhedraMeshes::SetLinear(grid);
  scene.SetMesh(grid);
  SetLinearEmission(scene);
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

int TestPolyhedraThreePasses(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMeshes::Entry& mesh : PolyhedraMeshes::All())
  {
    CheckLinearEmission(checks, mesh, 1);
    CheckLinearEmission(checks, mesh, 3);
    CheckAgainstOnePass(checks, mesh);
    CheckNearPlane(checks, mesh);
  }
  CheckTrapezoidRule(checks, 1);
  CheckTrapezoidRule(checks, 3);
  CheckConvergence(checks);
  CheckOtherCuts(checks);
  return checks.Result();
}
