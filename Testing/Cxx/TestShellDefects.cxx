// M2 to M11 of the usual defects, for each way in which vtkBarycentricShellMapper draws: in shells,
// by cell projection, and iso-surfaces where they can have the defect. M1 is in TestShellProjection.

#include "OpaquePlane.h"
#include "PolyhedraMeshes.h"
#include "SortMeshes.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"

#include "vtkCellType.h"
#include "vtkContourValues.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Size = 64;
const double Whole = 1.0 - std::exp(-1.0);

enum Way
{
  InShells,
  InOrder,
  Surfaces
};

class WayScene : public TestScene
{
public:
  explicit WayScene(Way way)
    : TestScene(vtkNew<vtkBarycentricShellMapper>(), Size, Size)
    , IsInOrder(way == InOrder)
  {
    auto* mapper = vtkBarycentricShellMapper::SafeDownCast(this->Mapper);
    mapper->SetMethod(way == InOrder ? vtkBarycentricShellMapper::CELL_PROJECTION
                                     : vtkBarycentricShellMapper::SHELLS);
    mapper->SetSamplesPerRay(200.0);
    mapper->SetBlendMode(
      way == Surfaces ? vtkConvexCellMapper::ISOSURFACE : vtkConvexCellMapper::COMPOSITE);
    this->Property->GetIsoSurfaceValues()->SetValue(0, 0.5);
    this->LookFrom(0.5, 0.8, 2.2);
  }
  /// What the way's integral is held to.
  double GetBound() const { return this->IsInOrder ? 2e-4 : 1e-3; }
  void LookAlongAxis()
  {
    this->LookFrom(0.0, 0.0, 3.0);
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Renderer->GetActiveCamera()->SetParallelScale(0.6);
    this->Renderer->GetActiveCamera()->SetClippingRange(1.0, 5.0);
  }
  void CheckExact(TestChecks& checks, const std::string& name)
  {
    const double error = this->MaximumError(name);
    checks.Check(
      error >= 0.0 && error <= this->GetBound(), name.c_str(), __LINE__, std::to_string(error));
  }
  int CountLit()
  {
    int lit = 0;
    for (int pixel = 0; pixel < Size * Size; ++pixel)
    {
      lit += this->Pixel(pixel % Size, pixel / Size)[3] > 0.0 ? 1 : 0;
    }
    return lit;
  }

private:
  const bool IsInOrder;
};

double Depth(const double* p)
{
  return p[2] + 0.5;
}

// M2: a slab of optical depth 1 in the world under any scale.
void CheckScale(TestChecks& checks, Way way)
{
  WayScene scene(way);
  scene.LookAlongAxis();
  scene.SetConstant(1.0);
  for (const double scale : { 0.1, 1.0, 3.0, 10.0 })
  {
    const double size[3] = { 2.0, 2.0, 1.0 / scale };
    const int cells[3] = { 3, 3, 2 };
    scene.SetGrid(TestMeshes::Slab(size, cells));
    scene.Volume->SetScale(1.0, 1.0, scale);
    scene.Render();
    CHECK_NEAR(scene.CenterPixel()[3], Whole, scene.GetBound());
  }
}

// M3: 24 numberings, one image but for rounding: coordinates count from the first corner.
void CheckNumbering(TestChecks& checks, Way way)
{
  WayScene scene(way);
  vtkBarycentricShellMapper::SafeDownCast(scene.Mapper)->SetSamplesPerRay(400.0);
  std::vector<int> numbering = { 0, 1, 2, 3 };
  scene.SetGrid(TestMeshes::Tetrahedron(numbering));
  scene.Render();
  auto first = scene.CopyCaptured();
  CHECK(scene.CountLit() > 100);
  while (std::next_permutation(numbering.begin(), numbering.end()))
  {
    scene.SetGrid(TestMeshes::Tetrahedron(numbering));
    scene.Render();
    const double difference = TestScene::Difference(first, scene.Mapper->GetCapturedImage());
    CHECK(difference >= 0.0);
    CHECK_AT_MOST(difference, 1e-5);
  }
}

// M4: from inside, with any near plane, every pixel.
void CheckInside(TestChecks& checks, Way way)
{
  WayScene scene(way);
  scene.SetMesh(TestMeshes::JitteredCube(3));
  scene.LookFrom(0.05, 0.02, 0.11);
  for (const double nearPlane : { 1e-3, 0.1 })
  {
    scene.Renderer->GetActiveCamera()->SetClippingRange(nearPlane, 10.0);
    scene.CheckExact(checks, "from inside");
    CHECK(scene.CountLit() == Size * Size);
  }
}

// M5: an opaque plane through the cells leaves the front part; a surface behind it is hidden.
void CheckOpaque(TestChecks& checks, Way way)
{
  WayScene scene(way);
  scene.LookAlongAxis();
  scene.SetConstant(1.0);
  auto grid = TestMeshes::SixTetrahedra();
  TestMeshes::SetField(grid, Depth);
  scene.SetGrid(grid);
  OpaquePlane::Add(scene, 0.1, 0.1);
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 0.55);
  scene.Render();
  CHECK_NEAR(scene.CenterPixel()[3], way == Surfaces ? 0.0 : 1.0 - std::exp(-0.4), scene.GetBound());
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 0.65);
  scene.Render();
  CHECK(way != Surfaces || scene.CenterPixel()[3] == 1.0);
}

// M6: two slabs seen obliquely, the near one in front.
void CheckSlabs(TestChecks& checks, Way way)
{
  WayScene scene(way);
  auto grid = SortMeshes::Slabs();
  PolyhedraMeshes::FitUnitCube(grid);
  TestMeshes::SetField(grid, TestMeshes::Waves);
  scene.SetMesh(grid);
  for (const double side : { 1.0, -1.0 })
  {
    scene.LookFrom(0.9 * side, 0.8, 1.4 * side);
    if (way == InOrder)
    {
      scene.CheckExact(checks, "slabs");
      continue;
    }
    scene.MaximumError("slabs");
    // In shells, single rays graze the gap within two slices.
    CHECK_AT_MOST(scene.Oracle->GetRootMeanSquareError(), 3e-4);
    CHECK_AT_MOST(scene.Oracle->GetPercentileError(), 2e-3);
  }
}

// Pixels of the window, from this column on, that are another colour than the captured image's.
int CountWrong(WayScene& scene, int column)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  scene.Window->GetPixelData(column, 0, column + Size - 1, Size - 1, 0, pixels);
  int wrong = 0;
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const double red = scene.Pixel(pixel % Size, pixel / Size)[0];
    wrong += std::abs(pixels->GetComponent(pixel, 0) / 255.0 - red) > 1.0 / 255.0 ? 1 : 0;
  }
  return wrong;
}

// M7: a second viewport.
void CheckViewports(TestChecks& checks, Way way)
{
  WayScene scene(way);
  scene.SetMesh(TestMeshes::SixTetrahedra());
  scene.Render();
  const int lit = scene.CountLit();
  scene.Window->SetSize(2 * Size, Size);
  scene.AddSecondViewport();
  scene.Render();
  CHECK(lit > 100 && scene.CountLit() == lit);
  CHECK(CountWrong(scene, 0) == 0);
  CHECK(CountWrong(scene, Size) == 0);
  if (way != Surfaces)
  {
    scene.CheckExact(checks, "second viewport");
  }
}

// M8: clipping planes change the image; what is not drawn is named, once; Shade lights surfaces.
void CheckSettings(TestChecks& checks, Way way)
{
  WayScene scene(way);
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.SetMesh(TestMeshes::JitteredCube(3));
  scene.Render();
  auto plain = scene.CopyCaptured();
  vtkNew<vtkPlaneCollection> planes;
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.3, 1.0, 0.0);
  planes->AddItem(plane);
  scene.Mapper->SetClippingPlanes(planes);
  scene.Render();
  CHECK(TestScene::CountDifferent(plain, scene.Mapper->GetCapturedImage(), 1e-2) > 100);
  scene.Mapper->SetClippingPlanes(static_cast<vtkPlaneCollection*>(nullptr));
  CHECK(messages->Count() == 0);
  scene.Property->ShadeOn();
  scene.Render();
  scene.Render();
  const bool isLit =
    TestScene::CountDifferent(plain, scene.Mapper->GetCapturedImage(), 1e-2) > 100;
  CHECK(isLit == (way == Surfaces));
  CHECK(messages->Count() == (way == Surfaces ? 0 : 1));
  scene.Mapper->SetBlendModeToMaximumIntensity();
  CHECK(messages->CountOf("vtkMaximumProjectionMapper") == 1);
}

// M9: new scalars on the same volume and property.
void CheckScalars(TestChecks& checks, Way way)
{
  WayScene scene(way);
  auto grid = TestMeshes::JitteredCube(3);
  scene.SetGrid(grid);
  scene.Render();
  auto before = scene.CopyCaptured();
  TestMeshes::SetField(grid, Depth);
  scene.Render();
  auto kept = scene.CopyCaptured();
  CHECK(TestScene::CountDifferent(before, kept, 1e-2) > 100);
  WayScene fresh(way);
  fresh.SetGrid(grid);
  fresh.Render();
  CHECK(TestScene::Difference(kept, fresh.Mapper->GetCapturedImage()) == 0.0);
}

// M10: other cells, fed directly.
void CheckCells(TestChecks& checks, Way way)
{
  WayScene scene(way);
  for (const int type : { VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    scene.SetMesh(TestMeshes::Cube(type));
    scene.Render();
    CHECK(scene.CountLit() > 300);
    if (way != Surfaces)
    {
      scene.CheckExact(checks, "type " + std::to_string(type));
    }
  }
}

// M11: a triangle among the tetrahedra.
void CheckTriangle(TestChecks& checks, Way way)
{
  WayScene scene(way);
  auto grid = TestMeshes::SixTetrahedra();
  scene.SetGrid(grid);
  scene.Render();
  auto before = scene.CopyCaptured();
  CHECK(scene.CountLit() > 300);
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  const vtkIdType ids[3] = { 0, 1, 2 };
  auto mixed = TestMeshes::SixTetrahedra();
  mixed->InsertNextCell(VTK_TRIANGLE, 3, ids);
  scene.SetGrid(mixed);
  scene.Render();
  CHECK(TestScene::Difference(before, scene.Mapper->GetCapturedImage()) == 0.0);
  CHECK(scene.GetStatistic("CellsSkippedInvalid") == 1);
  CHECK(messages->Count() == 1);
}
}

int TestShellDefects(int, char*[])
{
  TestChecks checks;
  for (const Way way : { InShells, InOrder })
  {
    CheckScale(checks, way);
    CheckInside(checks, way);
    CheckSlabs(checks, way);
  }
  for (const Way way : { InShells, InOrder, Surfaces })
  {
    CheckNumbering(checks, way);
    CheckOpaque(checks, way);
    CheckViewports(checks, way);
    CheckSettings(checks, way);
    CheckScalars(checks, way);
    CheckCells(checks, way);
    CheckTriangle(checks, way);
  }
  return checks.Result();
}
