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

void SetFunctions(TestScene& scene, vtkUnstructuredGrid* grid)
{
  double range[2];
  grid->GetPointData()->GetScalars()->GetRange(range);
  const auto at = [&](double share) { return range[0] + share * (range[1] - range[0]); };
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(at(0.0), 0.1, 0.2, 0.8);
  scene.Color->AddRGBPoint(at(1.0), 1.0, 0.3, 0.1);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(at(0.0), 0.02);
  scene.Opacity->AddPoint(at(0.3), 0.2);
  scene.Opacity->AddPoint(at(1.0), 1.0);
  scene.Property->SetScalarOpacityUnitDistance(grid->GetLength() / 20.0);
}

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
  SetFunctions(scene, grid);
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
