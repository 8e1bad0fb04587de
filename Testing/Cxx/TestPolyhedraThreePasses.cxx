// Three passes: per cell the trapezoid rule, mean of the emission g at entry and exit times the
// length. Exact where g is linear in the scalar; else off by length * d^2 / 12 * g'' in a cell
// along which the scalar changes by d. One pass with AverageEmission is the same rule with exact
// lengths.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"
#include "SortMeshes.h"
#include "TestMeshes.h"

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

void CheckLinearEmission(TestChecks& checks, const PolyhedraMeshes::Entry& mesh, int passes)
{
  PolyhedraScene scene(MakeMapper(passes, true), 64, 64);
  scene.SetMesh(mesh.Mesh);
  scene.SetLinearEmission();
  for (const int view : { 0, 1 })
  {
    scene.SetView(view);
    const std::string name =
      mesh.Name + ", linear emission, passes " + std::to_string(passes) + ", view ";
    scene.CheckMostPixels(checks, name + std::to_string(view), __LINE__);
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
    PolyhedraScene scene(MakeMapper(passes, true), 32, 32);
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

// Rays along faces and through edges: the rasteriser gives each to one side.
void CheckLattice(TestChecks& checks)
{
  PolyhedraScene scene(MakeMapper(3, false));
  auto grid = SortMeshes::Lattice(8);
  PolyhedraMeshes::FitUnitCube(grid);
  PolyhedraMeshes::SetWaves(grid);
  scene.SetMesh(grid);
  scene.SetLinearEmission();
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.5);
  const double eyes[4][3] = { { 0, 0, 3 }, { 3, 0, 0 }, { 2, 0, 2 }, { 2, 2, 2 } };
  for (const auto& eye : eyes)
  {
    scene.LookFrom(eye[0], eye[1], eye[2]);
    scene.CheckMostPixels(checks, "three passes, lattice", __LINE__);
  }
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
  }
  CheckTrapezoidRule(checks, 1);
  CheckTrapezoidRule(checks, 3);
  CheckConvergence(checks);
  CheckLattice(checks);
  return checks.Result();
}
