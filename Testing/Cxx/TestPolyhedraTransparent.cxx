// Cells whose scalars map to nothing are counted and left out, and the picture is that with them;
// for an extremum only where everything beyond is nothing, too: else they hide what is visible.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include <algorithm>

namespace
{
constexpr double Edge = 0.02;

// Opacity .8 from scalar to scalar, `nothing` elsewhere.
void SetVisible(PolyhedraScene& scene, double from, double to, double nothing)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(from - Edge, nothing);
  scene.Opacity->AddPoint(from, 0.8);
  scene.Opacity->AddPoint(to, 0.8);
  scene.Opacity->AddPoint(to + Edge, nothing);
}

// The same picture with and without; with an opacity of 1e-12 nothing is dropped.
void CheckWindow(TestChecks& checks, const PolyhedraMappers::Entry& mapper, double from, double to,
  vtkIdType least, vtkIdType most)
{
  PolyhedraScene scene(mapper.Make());
  scene.SetMesh(PolyhedraMeshes::Hexahedra(8));
  int lit = 0;
  for (int view = 0; view < PolyhedraScene::NumberOfViews; ++view)
  {
    scene.SetView(view);
    SetVisible(scene, from, to, 1e-12);
    scene.Render();
    auto with = scene.CopyCaptured();
    CHECK(scene.GetStatistic("CellsSkippedTransparent") == 0);
    CHECK(scene.GetStatistic("CellsDrawn") == 512);
    SetVisible(scene, from, to, 0.0);
    scene.Render();
    const vtkIdType skipped = scene.GetStatistic("CellsSkippedTransparent");
    const double difference = TestScene::Difference(with, scene.Mapper->GetCapturedImage());
    std::cout << mapper.Name << ", visible from " << from << " to " << to << ": " << skipped
              << " of 512 cells dropped, the image differs by " << difference << "\n";
    CHECK(difference >= 0.0);
    CHECK_AT_MOST(difference, 1e-6);
    CHECK(scene.GetStatistic("CellsDrawn") == 512 - skipped);
    CHECK(skipped >= least && skipped <= most);
    lit += scene.CountLitPixels();
  }
  CHECK(lit > 100);
}

// The cell before maps to nothing but at its end, and hides the visible one behind.
void CheckHiding(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make());
  const bool isMaximum = scene.Mapper->GetBlendMode() == vtkConvexCellMapper::MAXIMUM_INTENSITY;
  const double before = isMaximum ? 1.0 : 0.0, behind = 1.0 - before;
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int cells[3] = { 1, 1, 2 };
  auto grid = TestMeshes::Slab(size, cells);
  TestMeshes::SetField(
    grid, [=](const double* p) { return p[2] > 0.4    ? before
                                        : p[2] < -0.4 ? behind
                                                      : 0.5; });
  scene.SetMesh(grid);
  scene.LookFrom(0.0, 0.0, 3.0);
  SetVisible(scene, std::min(0.45, behind), std::max(0.55, behind), 0.0);
  scene.Render();
  CHECK(scene.CenterPixel()[3] == 0.0);
  CHECK(scene.GetStatistic("CellsDrawn") == 2);
  // From its other side, and with the opacities exchanged.
  scene.LookFrom(0.0, 0.0, -3.0);
  scene.Render();
  CHECK(scene.CenterPixel()[3] == 0.0);
  SetVisible(scene, std::min(0.55, before), std::max(0.45, before), 0.0);
  scene.Render();
  CHECK_NEAR(scene.CenterPixel()[3], 0.8, 1e-6);
  // Beyond .5 there is only the cell before.
  CHECK(scene.GetStatistic("CellsDrawn") == 1);
  SetVisible(
    scene, std::min(before, isMaximum ? 0.6 : 0.0), std::max(before, isMaximum ? 1.0 : 0.4), 0.0);
  scene.Render();
  CHECK_NEAR(scene.CenterPixel()[3], 0.8, 1e-6);
  CHECK(scene.GetStatistic("CellsDrawn") == 1);
  CHECK(scene.GetStatistic("CellsSkippedTransparent") == 1);
}

// Nothing is visible: nothing is drawn, without a word.
void CheckNothing(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make());
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.SetMesh(PolyhedraMeshes::Hexahedra(3));
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Render();
  CHECK(scene.GetStatistic("CellsSkippedTransparent") == 27);
  CHECK(scene.GetStatistic("CellsDrawn") == 0);
  CHECK(scene.CountLitPixels() == 0 && messages->Count() == 0);
}
}

int TestPolyhedraTransparent(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    const int mode = mapper.Make()->GetBlendMode();
    const bool isMaximum = mode == vtkConvexCellMapper::MAXIMUM_INTENSITY;
    const bool isMinimum = mode == vtkConvexCellMapper::MINIMUM_INTENSITY;
    // An extremum: from the end of the range on none can be dropped, and none beyond the visible.
    CheckWindow(checks, mapper, 0.6, 0.8, isMinimum ? 0 : 20, 400);
    CheckWindow(checks, mapper, 0.2, 0.4, isMaximum ? 0 : 20, 400);
    CheckWindow(checks, mapper, -0.1, 0.4, isMaximum ? 0 : 20, isMaximum ? 0 : 400);
    CheckWindow(checks, mapper, 0.6, 1.1, isMinimum ? 0 : 20, isMinimum ? 0 : 400);
    if (isMaximum || isMinimum)
    {
      CheckHiding(checks, mapper);
    }
    CheckNothing(checks, mapper);
  }
  return checks.Result();
}
