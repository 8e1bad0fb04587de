// Cells with a linear field give the same image whole and cut into tetrahedra: to 1e-4, and to 1e-5
// of the scalar's range for an extremum.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"

#include "vtkConvexCells.h"

namespace
{
void CheckMesh(TestChecks& checks, PolyhedraScene& scene, vtkUnstructuredGrid* mesh,
  vtkUnstructuredGrid* tetrahedra, const std::string& name)
{
  scene.Mapper->SetInputData(mesh);
  scene.Render();
  auto whole = scene.CopyCaptured();
  const vtkIdType drawnWhole = scene.GetStatistic("CellsDrawn");
  scene.Mapper->SetInputData(tetrahedra);
  scene.Render();
  vtkImageData* cut = scene.Mapper->GetCapturedImage();
  const int lit = scene.CountLitPixels();
  const int different = TestScene::CountDifferent(whole, cut, scene.GetBound());
  std::cout << name << ": differ by " << TestScene::Difference(whole, cut) << ", " << different
            << " of " << lit << " pixels by more than " << scene.GetBound() << "\n";
  // A warped face is two triangles with a dent between them, which a cell drawn whole fills: rays
  // that graze the dents of the hull see more of it.
  const bool warped = scene.IsAdditive() && name.find("curvilinear") == 0;
  checks.Check(different <= (warped ? 0.01 * lit : 0.0), name.c_str(), __LINE__,
    std::to_string(different) + " pixels differ");
  CHECK(scene.GetStatistic("CellsDrawn") == tetrahedra->GetNumberOfCells());
  CHECK(drawnWhole == mesh->GetNumberOfCells() || name.find("PentaHexa") == 0);
  CHECK(lit > 1000);
}
}

int TestPolyhedraCutUp(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMeshes::Entry& mesh : PolyhedraMeshes::All())
  {
    PolyhedraMeshes::SetLinear(mesh.Mesh);
    vtkNew<vtkConvexCells> cut;
    cut->SetInputData(mesh.Mesh);
    cut->TetrahedraOnlyOn();
    cut->Update();
    for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
    {
      PolyhedraScene scene(mapper.Make());
      for (int view = 0; view < PolyhedraScene::NumberOfViews; ++view)
      {
        scene.SetView(view);
        const std::string name = mesh.Name + ", " + mapper.Name + ", view " + std::to_string(view);
        CheckMesh(checks, scene, mesh.Mesh, cut->GetOutput(), name);
      }
    }
  }
  return checks.Result();
}
