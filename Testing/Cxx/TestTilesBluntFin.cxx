// NASA's Blunt Fin, whose cells at the wall are slivers: Tiles and Raster draw the same image where
// rays graze them. Needs CELLPROJECTION_DATA.

#include "RealMeshes.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>

namespace
{
constexpr int Skipped = 125;
constexpr double Bound = 1e-4;

vtkSmartPointer<vtkImageData> Draw(TestScene& scene, int engine)
{
  scene.Mapper->SetEngine(engine);
  scene.Render();
  return scene.CopyCaptured();
}
}

int TestTilesBluntFin(int, char*[])
{
  const auto grid = RealMeshes::Read("bluntFin");
  if (!grid)
  {
    return Skipped;
  }
  TestMeshes::SetField(grid, [](const double* p) { return std::sin(p[0] + p[1]) + 0.1 * p[2]; });
  TestChecks checks;
  TestScene scene(96, 96);
  scene.GetTetrahedraMapper()->SetVisibilitySort(nullptr);
  scene.SetGrid(grid);
  scene.SetReportSmooth(grid);
  for (const double angle : { 0.7, 2.3, 4.0 })
  {
    scene.LookFrom(0.8 * std::cos(angle), -0.6, 0.8 * std::sin(angle));
    scene.Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    scene.Renderer->ResetCamera();
    const auto tiles = Draw(scene, vtkConvexCellMapper::TILES);
    const auto raster = Draw(scene, vtkConvexCellMapper::RASTER);
    const double difference = TestScene::Difference(tiles, raster);
    std::cout << "eye at " << angle << ": difference " << difference << "\n";
    CHECK(difference >= 0.0);
    CHECK_AT_MOST(difference, Bound);
  }
  return checks.Result();
}
