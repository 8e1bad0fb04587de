#include "BenchmarkError.h"

#include "BenchmarkMapper.h"
#include "BenchmarkScene.h"

#include "vtkCellProjectionOracle.h"
#include "vtkConvexCellMapper.h"
#include "vtkImageData.h"
#include "vtkUnstructuredGrid.h"

#include <memory>

namespace
{
// VTK's window shows colours alone: the oracle's own alpha keeps alpha out of the comparison.
vtkSmartPointer<vtkImageData> CaptureWindow(BenchmarkScene& scene, vtkImageData* oracle)
{
  auto image = scene.ReadWindow();
  const int* size = image->GetDimensions();
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      image->SetScalarComponentFromDouble(
        x, y, 0, 3, oracle->GetScalarComponentAsDouble(x, y, 0, 3));
    }
  }
  return image;
}

void DrawOracle(
  vtkCellProjectionOracle* oracle, BenchmarkScene& scene, vtkUnstructuredGrid* grid, int size)
{
  oracle->SetInputData(grid);
  oracle->SetVolume(scene.Volume);
  oracle->SetCamera(scene.Renderer->GetActiveCamera());
  oracle->SetSize(size, size);
  oracle->Update();
}
}

//------------------------------------------------------------------------------
BenchmarkError BenchmarkError::Measure(const BenchmarkMapper& mapper, vtkUnstructuredGrid* grid,
  bool spiky, int size, vtkCellProjectionOracle* oracle)
{
  const std::unique_ptr<BenchmarkScene> scene = mapper.Show(grid, size, spiky);
  auto* ours = vtkConvexCellMapper::SafeDownCast(scene->Volume->GetMapper());
  if (ours)
  {
    ours->CaptureImageOn();
  }
  // Of the first frame of VTK's projected tetrahedra a part is missing.
  scene->TimeFrame(0);
  scene->TimeFrame(0);
  if (!oracle->GetImage())
  {
    DrawOracle(oracle, *scene, grid, size);
  }
  const vtkSmartPointer<vtkImageData> image =
    ours ? ours->GetCapturedImage() : CaptureWindow(*scene, oracle->GetImage()).GetPointer();
  oracle->Compare(image);
  return { oracle->GetRootMeanSquareError(), oracle->GetPercentileError(),
    oracle->GetMaximumError(), oracle->GetShareAboveHalfLevel() };
}
