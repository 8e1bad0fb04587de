#include "ShellBenchmark.h"

#include "BenchmarkScene.h"

#include "vtkBarycentricShellMapper.h"
#include "vtkContourValues.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cstdio>

namespace
{
// The second one is the paper's, of which software OpenGL draws a frame in seconds.
constexpr int ImageSizes[2] = { 128, 512 };
// Of each row, at most.
constexpr int MaximumFrames[2] = { 3, 1 };
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

void MakeOpaque(BenchmarkScene& scene, vtkUnstructuredGrid* grid)
{
  double range[2];
  grid->GetScalarRange(range);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  property->GetIsoSurfaceValues()->SetValue(0, 0.5 * (range[0] + range[1]));
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(range[0], 1.0);
}

Times Measure(vtkBarycentricShellMapper* mapper, vtkUnstructuredGrid* grid, int size, int frames)
{
  BenchmarkScene scene(mapper, grid, GeometrySize);
  if (mapper->GetBlendMode() == vtkConvexCellMapper::ISOSURFACE)
  {
    MakeOpaque(scene, grid);
  }
  // Shaders and arrays are ready before the first large frame.
  scene.TimeFrame(0);
  scene.Window->SetSize(size, size);
  std::vector<double> prepare, upload, project, total;
  for (int frame = 1; frame <= frames; ++frame)
  {
    scene.MoveEye(frame);
    Move(grid);
    total.push_back(scene.TimeRender());
    vtkTable* row = mapper->GetLastStatistics();
    prepare.push_back(row->GetValueByName(0, "SecondsPrepare").ToDouble());
    project.push_back(row->GetValueByName(0, "SecondsProject").ToDouble());
    upload.push_back(mapper->GetUploadSeconds());
  }
  return { Median(prepare), Median(upload), Median(project), Median(total) };
}

void PrintShells(
  vtkUnstructuredGrid* grid, int samplesPerRay, int samplesPerShell, int size, int frames)
{
  vtkNew<vtkBarycentricShellMapper> mapper;
  mapper->SetSamplesPerRay(samplesPerRay);
  mapper->SetSamplesPerShell(samplesPerShell);
  mapper->SetIntegrationToPoint();
  const Times geometry = Measure(mapper, grid, GeometrySize, frames);
  const Times times = Measure(mapper, grid, size, frames);
  std::printf("%10d %9d %10lld %10.2f %9.2f %8.1f %9.1f %10.1f %9.1f %8.2f\n", samplesPerRay,
    samplesPerShell, static_cast<long long>(mapper->GetNumberOfElementsDrawn()),
    mapper->GetMeshBytes() / 1048576.0, mapper->GetTargetBytes() / 1048576.0, 1e3 * times.Prepare,
    1e3 * geometry.Project, 1e3 * (times.Project - geometry.Project), 1e3 * times.Total,
    100.0 * times.Upload / times.Total);
}

void PrintOthers(vtkUnstructuredGrid* grid, int size, int frames)
{
  vtkNew<vtkBarycentricShellMapper> surfaces;
  surfaces->SetBlendModeToIsoSurface();
  vtkNew<vtkBarycentricShellMapper> ordered;
  ordered->SetMethodToCellProjection();
  std::printf("  iso-surface %.1f ms, cell projection %.1f ms\n",
    1e3 * Measure(surfaces, grid, size, frames).Total,
    1e3 * Measure(ordered, grid, size, frames).Total);
}

void PrintTables(const std::string& name, vtkUnstructuredGrid* tetrahedra, int samplesPerRay,
  int size, int frames)
{
  std::printf("%s, %lld tetrahedra in shells, %d x %d pixels, %d frames, moved points in each\n",
    name.c_str(), static_cast<long long>(tetrahedra->GetNumberOfCells()), size, size, frames);
  std::printf("%10s %9s %10s %10s %9s %8s %9s %10s %9s %8s\n", "samples", "per shell", "drawn",
    "mesh MiB", "targets", "CPU ms", "geometry", "fragments", "total ms", "upload %");
  for (const int samplesPerShell : { 4, 8, 16 })
  {
    PrintShells(tetrahedra, samplesPerRay, samplesPerShell, size, frames);
  }
  PrintOthers(tetrahedra, size, frames);
}
}

//------------------------------------------------------------------------------
void ShellBenchmark::Run(
  const std::string& name, vtkUnstructuredGrid* tetrahedra, int samplesPerRay, int wantedFrames)
{
  for (int i = 0; i < 2; ++i)
  {
    PrintTables(name, tetrahedra, samplesPerRay, ImageSizes[i],
      std::min(wantedFrames, MaximumFrames[i]));
  }
}
