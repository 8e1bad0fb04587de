// What every mapper shares, drawn in shells, against the oracle: opaque geometry, clipping planes,
// near planes in the mesh, viewports, cells of every type, transparent cells. Meshes that are
// cyclic, concave or shuffled need nothing special.

#include "OpaquePlane.h"
#include "PolyhedraMeshes.h"
#include "SortMeshes.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkVariant.h"

namespace
{
constexpr double Bound = 1e-3;

class ShellScene : public TestScene
{
public:
  ShellScene()
    : TestScene(vtkNew<vtkBarycentricShellMapper>(), 64, 64)
  {
  }
};

#define CHECK_EXACT(scene, name)                     \
  {                                                  \
    const double error = (scene).MaximumError(name); \
    CHECK(error >= 0.0);                             \
    CHECK_AT_MOST(error, Bound);                     \
  }

void CheckOpaque(TestChecks& checks)
{
  ShellScene scene;
  scene.SetMesh(TestMeshes::SixTetrahedra());
  OpaquePlane::Add(scene, 0.1, 0.1);
  scene.LookFrom(0.0, 0.0, 2.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.9);
  scene.Renderer->GetActiveCamera()->SetClippingRange(1.0, 3.0);
  vtkNew<vtkFloatArray> depths;
  for (int i = 0; i < 64 * 64; ++i)
  {
    depths->InsertNextValue(0.45f);
  }
  scene.Oracle->SetOpaqueDepth(depths);
  CHECK_EXACT(scene, "opaque plane");
}

void CheckCuts(TestChecks& checks)
{
  ShellScene scene;
  scene.SetMesh(TestMeshes::JitteredCube(3));
  scene.Volume->RotateY(20.0);
  scene.Volume->SetScale(1.0, 1.2, 0.9);
  CHECK_EXACT(scene, "moved and scaled");
  vtkNew<vtkPlaneCollection> planes;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.1, 0.0, 0.0);
  plane->SetNormal(1.0, 0.3, 0.2);
  planes->AddItem(plane);
  scene.Mapper->SetClippingPlanes(planes);
  scene.Oracle->SetClippingPlanes(planes);
  CHECK_EXACT(scene, "clipped");
  CHECK(scene.GetStatistic("CellsSkippedOutside") > 0);
  scene.Mapper->SetClippingPlanes(static_cast<vtkPlaneCollection*>(nullptr));
  scene.Oracle->SetClippingPlanes(nullptr);
  for (const double nearPlane : { 1e-3, 0.1, 0.3 })
  {
    scene.LookFrom(0.05, 0.02, 0.11);
    scene.Renderer->GetActiveCamera()->SetClippingRange(nearPlane, 10.0);
    CHECK_EXACT(scene, "from inside");
    CHECK(scene.Oracle->GetNumberOfCoveredPixels() == 64 * 64);
  }
  scene.LookFrom(0.3, 0.4, 2.0);
  scene.Renderer->GetActiveCamera()->SetClippingRange(1.9, 2.2);
  CHECK_EXACT(scene, "near and far plane through the mesh");
}

void CheckViewports(TestChecks& checks)
{
  ShellScene scene;
  scene.SetMesh(TestMeshes::SixTetrahedra());
  scene.Window->SetSize(128, 64);
  scene.AddSecondViewport();
  CHECK_EXACT(scene, "second viewport");
  scene.Window->SetSize(160, 80);
  CHECK_EXACT(scene, "another size");
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  CHECK_EXACT(scene, "after a release");
}

void CheckCells(TestChecks& checks)
{
  ShellScene scene;
  for (const int type : { VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    scene.SetMesh(TestMeshes::Cube(type));
    CHECK_EXACT(scene, "type " + std::to_string(type));
  }
  auto grid = TestMeshes::SixTetrahedra();
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("cells");
  for (int i = 0; i < 6; ++i)
  {
    cells->InsertNextValue(0.15 * i);
  }
  grid->GetCellData()->SetScalars(cells);
  scene.SetMesh(grid);
  scene.Mapper->SetScalarModeToUseCellData();
  scene.Oracle->SetCellScalars(true);
  scene.Render();
  // Constant in each cell, so between two slices of different cells the mean of both is right.
  const double error = scene.MaximumError("cell scalars");
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 5e-3);
}

void CheckTransparent(TestChecks& checks)
{
  ShellScene scene;
  scene.SetMesh(TestMeshes::JitteredCube(4));
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.6, 0.0);
  scene.Opacity->AddPoint(1.0, 3.0);
  CHECK_EXACT(scene, "transparent cells");
  const int skipped = scene.GetStatistic("CellsSkippedTransparent");
  CHECK(skipped > 30);
  CHECK(scene.GetStatistic("CellsDrawn") + scene.GetStatistic("CellsSkippedOutside") + skipped ==
        6 * 64);
}

// The same cells, each seventh one first, then those after them, and so on.
vtkSmartPointer<vtkUnstructuredGrid> WithCellsTurnedAround(vtkUnstructuredGrid* grid)
{
  auto turned = vtkSmartPointer<vtkUnstructuredGrid>::New();
  turned->SetPoints(grid->GetPoints());
  turned->GetPointData()->ShallowCopy(grid->GetPointData());
  vtkNew<vtkIdList> ids;
  for (vtkIdType start = 6; start >= 0; --start)
  {
    for (vtkIdType cell = start; cell < grid->GetNumberOfCells(); cell += 7)
    {
      grid->GetCellPoints(cell, ids);
      turned->InsertNextCell(grid->GetCellType(cell), ids);
    }
  }
  return turned;
}

void CheckHardMeshes(TestChecks& checks)
{
  for (const char* name : { "bars", "checkerboard", "hollowSphere", "slantedGear" })
  {
    ShellScene scene;
    auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
    auto grid = SortMeshes::Make(name);
    checks.Check(grid != nullptr, name, __LINE__);
    PolyhedraMeshes::FitUnitCube(grid);
    TestMeshes::SetField(grid, TestMeshes::Waves);
    scene.SetMesh(grid);
    scene.MaximumError(name);
    // Single rays graze edges, where the mesh ends and begins within two slices.
    CHECK_AT_MOST(scene.Oracle->GetRootMeanSquareError(), 3e-4);
    auto before = scene.CopyCaptured();
    mapper->SetInputData(WithCellsTurnedAround(grid));
    scene.Render();
    CHECK(TestScene::Difference(before, scene.Mapper->GetCapturedImage()) == 0.0);
  }
}
}

int TestShellScenes(int, char*[])
{
  TestChecks checks;
  CheckOpaque(checks);
  CheckCuts(checks);
  CheckViewports(checks);
  CheckCells(checks);
  CheckTransparent(checks);
  CheckHardMeshes(checks);
  return checks.Result();
}
