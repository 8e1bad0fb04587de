#include "ShellBenchmark.h"

#include "BenchmarkScene.h"

#include "vtkActor.h"
#include "vtkBarycentricShellMapper.h"
#include "vtkContourFilter.h"
#include "vtkContourValues.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cstdio>

namespace
{
// The paper has 512, of which software OpenGL draws a frame in many seconds.
constexpr int ImageSize = 128;
// Of each row, at most.
constexpr int MaximumFrames = 3;
// So small that fragments cost nothing beside the geometry of the elements.
constexpr int GeometrySize = 8;

struct Times
{
  double Prepare = 0.0;
  double Upload = 0.0;
  double Project = 0.0;
  double Total = 0.0;
};

// The points as they are, but new.
void Move(vtkUnstructuredGrid* grid)
{
  grid->GetPoints()->Modified();
}

Times Measure(vtkBarycentricShellMapper* mapper, vtkUnstructuredGrid* grid, int size, int frames)
{
  BenchmarkScene scene(mapper, grid, size);
  vtkContourValues* contours = scene.Volume->GetProperty()->GetIsoSurfaceValues();
  double range[2];
  grid->GetScalarRange(range);
  contours->SetValue(0, 0.5 * (range[0] + range[1]));
  scene.TimeFrame(0);
  std::vector<double> prepare, upload, project, total;
  for (int frame = 1; frame <= frames; ++frame)
  {
    Move(grid);
    total.push_back(scene.TimeFrame(frame));
    vtkTable* row = mapper->GetLastStatistics();
    prepare.push_back(row->GetValueByName(0, "SecondsPrepare").ToDouble());
    project.push_back(row->GetValueByName(0, "SecondsProject").ToDouble());
    upload.push_back(mapper->GetUploadSeconds());
  }
  return { Median(prepare), Median(upload), Median(project), Median(total) };
}

void PrintShells(vtkUnstructuredGrid* grid, int samplesPerRay, int samplesPerShell, int frames)
{
  vtkNew<vtkBarycentricShellMapper> mapper;
  mapper->SetSamplesPerRay(samplesPerRay);
  mapper->SetSamplesPerShell(samplesPerShell);
  mapper->SetIntegrationToPoint();
  const Times geometry = Measure(mapper, grid, GeometrySize, frames);
  const Times times = Measure(mapper, grid, ImageSize, frames);
  std::printf("%10d %9d %10lld %10.2f %9.2f %8.1f %9.1f %10.1f %9.1f %8.2f\n", samplesPerRay,
    samplesPerShell, static_cast<long long>(mapper->GetNumberOfElementsDrawn()),
    mapper->GetMeshBytes() / 1048576.0, mapper->GetTargetBytes() / 1048576.0, 1e3 * times.Prepare,
    1e3 * geometry.Project, 1e3 * (times.Project - geometry.Project), 1e3 * times.Total,
    100.0 * times.Upload / times.Total);
}

double MeasureContour(vtkUnstructuredGrid* grid, int frames)
{
  // A scene with the same camera, whose volume is not drawn.
  vtkNew<vtkBarycentricShellMapper> unused;
  BenchmarkScene scene(unused, grid, ImageSize);
  scene.Volume->VisibilityOff();
  double range[2];
  grid->GetScalarRange(range);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(grid);
  contour->SetValue(0, 0.5 * (range[0] + range[1]));
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(contour->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  scene.TimeFrame(0);
  std::vector<double> total;
  for (int frame = 1; frame <= frames; ++frame)
  {
    Move(grid);
    grid->Modified();
    total.push_back(scene.TimeFrame(frame));
  }
  return Median(total);
}

void PrintOthers(vtkUnstructuredGrid* grid, int frames)
{
  vtkNew<vtkBarycentricShellMapper> surfaces;
  surfaces->SetBlendModeToIsoSurface();
  vtkNew<vtkBarycentricShellMapper> ordered;
  ordered->SetMethodToCellProjection();
  std::printf("  iso-surface %.1f ms, vtkContourFilter and drawing %.1f ms, cell projection %.1f "
              "ms\n",
    1e3 * Measure(surfaces, grid, ImageSize, frames).Total, 1e3 * MeasureContour(grid, frames),
    1e3 * Measure(ordered, grid, ImageSize, frames).Total);
}
}

//------------------------------------------------------------------------------
void ShellBenchmark::Run(
  const std::string& name, vtkUnstructuredGrid* tetrahedra, int samplesPerRay, int wantedFrames)
{
  const int frames = std::min(wantedFrames, MaximumFrames);
  std::printf("%s, %lld tetrahedra in shells, %d x %d pixels, %d frames, moved points in each\n",
    name.c_str(), static_cast<long long>(tetrahedra->GetNumberOfCells()), ImageSize, ImageSize,
    frames);
  std::printf("%10s %9s %10s %10s %9s %8s %9s %10s %9s %8s\n", "samples", "per shell", "drawn",
    "mesh MiB", "targets", "CPU ms", "geometry", "fragments", "total ms", "upload %");
  for (const int samplesPerShell : { 4, 8, 16 })
  {
    PrintShells(tetrahedra, samplesPerRay, samplesPerShell, frames);
  }
  PrintOthers(tetrahedra, frames);
}
