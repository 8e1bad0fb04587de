#include "SimplificationBenchmark.h"

#include "BenchmarkScene.h"

#include "vtkImageData.h"
#include "vtkPreIntegratedTetrahedraMapper.h"
#include "vtkTetrahedraSimplifier.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstdio>

namespace
{
constexpr int ImageSize = 512;

// Of red, green and blue, over the pixels that the volume covers in either, in levels of 255.
double MeanDifference(vtkImageData* a, vtkImageData* b)
{
  const auto* p = static_cast<const float*>(a->GetScalarPointer());
  const auto* q = static_cast<const float*>(b->GetScalarPointer());
  double sum = 0.0;
  long long covered = 0;
  for (vtkIdType i = 0; i < 4 * a->GetNumberOfPoints(); i += 4)
  {
    if (p[i + 3] > 0.0f || q[i + 3] > 0.0f)
    {
      ++covered;
      for (int channel = 0; channel < 3; ++channel)
      {
        sum += std::abs(p[i + channel] - q[i + channel]) / 3.0;
      }
    }
  }
  return covered > 0 ? 255.0 * sum / covered : 0.0;
}
}

//------------------------------------------------------------------------------
SimplificationBenchmark::SimplificationBenchmark(
  const std::string& name, vtkUnstructuredGrid* tetrahedra)
  : Name(name)
  , Tetrahedra(tetrahedra)
{
}

//------------------------------------------------------------------------------
SimplificationBenchmark::Level SimplificationBenchmark::Measure(
  vtkUnstructuredGrid* grid, int frames, BenchmarkScene* original)
{
  Level level;
  level.Cells = grid->GetNumberOfCells();
  vtkNew<vtkPreIntegratedTetrahedraMapper> mapper;
  mapper->CaptureImageOn();
  BenchmarkScene scene(mapper, grid, ImageSize);
  if (original)
  {
    // The same colours and eyes, though bounds and range may be a little less.
    scene.Volume->SetProperty(original->Volume->GetProperty());
    scene.Renderer->SetActiveCamera(original->Renderer->GetActiveCamera());
  }
  scene.TimeFrame(0);
  if (original)
  {
    level.ImageError = MeanDifference(this->Image, mapper->GetCapturedImage());
  }
  else
  {
    this->Image = vtkSmartPointer<vtkImageData>::New();
    this->Image->DeepCopy(mapper->GetCapturedImage());
  }
  mapper->CaptureImageOff();
  std::vector<double> seconds;
  for (int frame = 1; frame <= frames; ++frame)
  {
    seconds.push_back(scene.TimeFrame(frame));
  }
  level.Frame = Median(seconds);
  return level;
}

//------------------------------------------------------------------------------
void SimplificationBenchmark::PrintHeader()
{
  std::printf("mesh,error bound %%,error %%,tetrahedra,share %%,simplify s,k tetrahedra/s,"
              "frame ms,speed-up,mean image error of 255\n");
}

//------------------------------------------------------------------------------
void SimplificationBenchmark::Print(const Level& level, const Level& original) const
{
  std::printf("%s,%g,%.2f,%lld,%.2f,%.2f,%.0f,%.1f,%.2f,%.2f\n", this->Name.c_str(),
    100.0 * level.Bound, 100.0 * level.Error, static_cast<long long>(level.Cells),
    100.0 * level.Cells / original.Cells, level.Seconds,
    level.Seconds > 0.0 ? 1e-3 * original.Cells / level.Seconds : 0.0, 1e3 * level.Frame,
    original.Frame / level.Frame, level.ImageError);
}

//------------------------------------------------------------------------------
void SimplificationBenchmark::Run(const std::vector<double>& bounds, int frames)
{
  const Level original = this->Measure(this->Tetrahedra, frames, nullptr);
  this->Print(original, original);
  vtkNew<vtkPreIntegratedTetrahedraMapper> mapper;
  BenchmarkScene scene(mapper, this->Tetrahedra, ImageSize);
  for (const double bound : bounds)
  {
    vtkNew<vtkTetrahedraSimplifier> simplifier;
    simplifier->SetInputData(this->Tetrahedra);
    simplifier->SetMaximumFieldError(bound);
    simplifier->Update();
    Level level = this->Measure(simplifier->GetOutput(), frames, &scene);
    level.Bound = bound;
    level.Error = simplifier->GetFieldError();
    level.Seconds = simplifier->GetSeconds();
    this->Print(level, original);
  }
}
