// Worlds from 1e-15 to 1e18 in size, under the clipping range that VTK chooses: the image of the
// same mesh of size 1, by every mapper and engine.

#include "PolyhedraScene.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkBarycentricShellMapper.h"

namespace
{
vtkSmartPointer<vtkUnstructuredGrid> Scaled(double size)
{
  auto grid = TestMeshes::JitteredCube(2);
  TestMeshes::SetField(grid, TestMeshes::Waves);
  vtkNew<vtkPoints> points;
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    const double* p = grid->GetPoint(id);
    points->InsertNextPoint(size * p[0], size * p[1], size * p[2]);
  }
  grid->SetPoints(points);
  return grid;
}

// Opacity is that of a length, which grows with the world.
void Show(TestScene& scene, double size)
{
  scene.Property->SetScalarOpacityUnitDistance(size);
  scene.SetMesh(Scaled(size));
  scene.LookFrom(0.5 * size, 0.8 * size, 2.2 * size);
  scene.Renderer->ResetCameraClippingRange();
}

void CheckComposite(TestChecks& checks, vtkConvexCellMapper* mapper, int engine, double size)
{
  TestScene scene(mapper, 64, 64);
  mapper->SetEngine(engine);
  Show(scene, size);
  const double error = scene.MaximumError(std::string(mapper->GetClassName()) + ", engine " +
                                          std::to_string(engine) + ", size " + std::to_string(size));
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 1e-4);
}

void CheckPolyhedra(
  TestChecks& checks, const PolyhedraMappers::Entry& mapper, int engine, double size)
{
  PolyhedraScene scene(mapper.Make(), 64, 64);
  scene.Mapper->SetEngine(engine);
  scene.SetFunctions();
  Show(scene, size);
  scene.CheckWithOracle(checks, mapper.Name + ", size " + std::to_string(size), __LINE__);
}
}

int TestWorldSizes(int, char*[])
{
  TestChecks checks;
  for (const double size : { 1e-15, 1e-6, 1e6, 1e18 })
  {
    for (const int engine : { vtkConvexCellMapper::RASTER, vtkConvexCellMapper::TILES })
    {
      CheckComposite(checks, vtkNew<vtkPreIntegratedTetrahedraMapper>(), engine, size);
      for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
      {
        CheckPolyhedra(checks, mapper, engine, size);
      }
    }
    CheckComposite(
      checks, vtkNew<vtkBarycentricShellMapper>(), vtkConvexCellMapper::RASTER, size);
  }
  return checks.Result();
}
