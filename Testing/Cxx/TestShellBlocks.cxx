// A memory limit of a tenth of the mesh cuts it into blocks, and the image is the same to the last
// bit; a limit that holds no block is named.

#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"

namespace
{
constexpr double MiB = 1048576.0;

void CheckSame(TestChecks& checks, TestScene& scene, vtkBarycentricShellMapper* mapper)
{
  for (const int integration :
    { vtkBarycentricShellMapper::POINT, vtkBarycentricShellMapper::PRE_INTEGRATED })
  {
    mapper->SetIntegration(integration);
    mapper->SetMemoryLimit(0.0);
    scene.Render();
    auto whole = scene.CopyCaptured();
    const vtkIdType bytes = mapper->GetMeshBytes();
    CHECK(scene.CenterPixel()[3] > 0.1);
    mapper->SetMemoryLimit(0.1 * static_cast<double>(bytes) / MiB);
    scene.Render();
    CHECK(10 * mapper->GetMeshBytes() <= bytes);
    CHECK(mapper->GetUploadedBytes() > bytes);
    CHECK(TestScene::Difference(whole, scene.Mapper->GetCapturedImage()) == 0.0);
    mapper->SetMemoryLimit(0.0);
    scene.Render();
    CHECK(TestScene::Difference(whole, scene.Mapper->GetCapturedImage()) == 0.0);
  }
}
}

int TestShellBlocks(int, char*[])
{
  TestChecks checks;
  TestScene scene(vtkNew<vtkBarycentricShellMapper>(), 48, 48);
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  mapper->SetSamplesPerRay(100.0);
  auto grid = TestMeshes::JitteredCube(22);
  scene.SetGrid(grid);
  CheckSame(checks, scene, mapper);
  vtkNew<vtkDoubleArray> cells;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    cells->InsertNextValue(0.01 * (cell % 100));
  }
  cells->SetName("cells");
  grid->GetCellData()->SetScalars(cells);
  mapper->SetScalarModeToUseCellData();
  CheckSame(checks, scene, mapper);
  vtkNew<MessageObserver> messages;
  messages->Watch(mapper);
  mapper->SetMemoryLimit(1e-4);
  scene.Render();
  CHECK(messages->Count() == 1 && messages->CountOf("holds no block") == 1);
  mapper->SetMemoryLimit(-1.0);
  CHECK(messages->CountOf("must not be negative") == 1);
  CHECK(mapper->GetMemoryLimit() == 1e-4);
  return checks.Result();
}
