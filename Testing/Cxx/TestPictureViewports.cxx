// A picture: perspective, parallel, cell scalars and the camera inside, in four viewports.

#include "TestMeshes.h"
#include "TestPicture.h"
#include "TestScene.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"

namespace
{
void AddCellScalars(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("cells");
  for (vtkIdType id = 0; id < grid->GetNumberOfCells(); ++id)
  {
    values->InsertNextValue((id * 37 % 11) / 10.0);
  }
  grid->GetCellData()->AddArray(values);
}
}

int TestPictureViewports(int argc, char* argv[])
{
  TestScene scene(256, 256);
  auto grid = TestMeshes::Curvilinear(4);
  AddCellScalars(grid);
  scene.SetGrid(grid);
  vtkNew<vtkPreIntegratedTetrahedraMapper> cellMapper;
  cellMapper->SetInputData(grid);
  cellMapper->SetScalarModeToUseCellFieldData();
  cellMapper->SelectScalarArray("cells");
  vtkNew<vtkVolume> cellVolume;
  cellVolume->SetMapper(cellMapper);
  cellVolume->SetProperty(scene.Property);

  vtkNew<vtkRenderer> renderers[3];
  for (int i = 0; i < 3; ++i)
  {
    const double x = i == 1 ? 0.0 : 0.5;
    const double y = i == 0 ? 0.0 : 0.5;
    renderers[i]->SetViewport(x, y, x + 0.5, y + 0.5);
    renderers[i]->SetBackground(0.2 + 0.2 * i, 0.3, 0.3);
    renderers[i]->AddVolume(i == 1 ? cellVolume.GetPointer() : scene.Volume.GetPointer());
    vtkCamera* camera = renderers[i]->GetActiveCamera();
    camera->SetPosition(1.0, 1.2, 2.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetClippingRange(0.01, 10.0);
    scene.Window->AddRenderer(renderers[i]);
  }
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 0.5);
  renderers[0]->GetActiveCamera()->ParallelProjectionOn();
  renderers[2]->GetActiveCamera()->SetPosition(0.3, 0.1, 0.2);
  scene.Render();
  return AgreesWithBaseline(argc, argv, scene.Window) ? 0 : 1;
}
