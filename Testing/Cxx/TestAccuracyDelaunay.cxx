// A Delaunay mesh of 10,000 tetrahedra in an exact order, computed here, against the oracle.

#include "TangentialSort.h"
#include "TestMeshes.h"
#include "TestScene.h"

int TestAccuracyDelaunay(int, char*[])
{
  TestChecks checks;
  TestScene scene;
  auto grid = TestMeshes::Delaunay(1600);
  std::cout << grid->GetNumberOfCells() << " tetrahedra\n";
  CHECK(grid->GetNumberOfCells() > 9500);
  scene.SetGrid(grid);
  // vtkDelaunay3D leaves dents in its hull: an order by shared faces alone would not be exact.
  vtkNew<TangentialSort> sort;
  scene.GetTetrahedraMapper()->SetVisibilitySort(sort);
  const double eyes[3][3] = { { 0.5, 0.8, 2.2 }, { -1.4, 0.3, -0.9 }, { 0.1, 0.05, 0.2 } };
  for (const auto& eye : eyes)
  {
    scene.LookFrom(eye[0], eye[1], eye[2]);
    for (const bool spiky : { false, true })
    {
      spiky ? scene.SetSpiky() : scene.SetSmooth();
      const double error = scene.MaximumError(spiky ? "Delaunay, spiky" : "Delaunay, smooth");
      CHECK(error >= 0.0);
      CHECK_AT_MOST(error, 2e-4);
    }
  }
  return checks.Result();
}
