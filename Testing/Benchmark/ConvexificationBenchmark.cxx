#include "ConvexificationBenchmark.h"

#include "BenchmarkScene.h"
#include "SortMeshes.h"

#include "vtkCamera.h"
#include "vtkConvexCells.h"
#include "vtkConvexifyFilter.h"
#include "vtkMPVOVisibilitySort.h"
#include "vtkMatrix4x4.h"
#include "vtkPreIntegratedTetrahedraMapper.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace
{
constexpr int ImageSize = 512;

// Median seconds to bring the cells in order for an eye that moves each frame.
double TimeSort(vtkMPVOVisibilitySort* sort, vtkUnstructuredGrid* grid, int frames)
{
  vtkNew<vtkCamera> camera;
  double center[3];
  grid->GetCenter(center);
  camera->SetFocalPoint(center);
  sort->SetInput(grid);
  sort->SetCamera(camera);
  vtkNew<vtkMatrix4x4> identity;
  sort->SetModelTransform(identity);
  std::vector<double> seconds;
  for (int frame = 0; frame <= frames; ++frame)
  {
    const double angle = 0.7 + 0.1 * frame, distance = 1.3 * grid->GetLength();
    camera->SetPosition(center[0] + distance * std::cos(angle), center[1] + 0.6 * distance,
      center[2] + distance * std::sin(angle));
    const auto start = std::chrono::steady_clock::now();
    sort->InitTraversal();
    while (sort->GetNextCells())
    {
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    // The first frame builds what the others use.
    if (frame > 0)
    {
      seconds.push_back(passed.count());
    }
  }
  return Median(seconds);
}

// Median seconds of a frame, the sort apart.
double TimeProjection(vtkUnstructuredGrid* grid, int frames)
{
  vtkNew<vtkPreIntegratedTetrahedraMapper> mapper;
  // The engine that takes the order of the sort.
  mapper->SetEngineToRaster();
  vtkNew<vtkMPVOVisibilitySort> sort;
  sort->ConvexifyOff();
  mapper->SetVisibilitySort(sort);
  BenchmarkScene scene(mapper, grid, ImageSize);
  std::vector<double> seconds;
  for (int frame = 0; frame <= frames; ++frame)
  {
    const double whole = scene.TimeFrame(frame);
    seconds.push_back(
      whole - mapper->GetLastStatistics()->GetValueByName(0, "SecondsSort").ToDouble());
  }
  return Median(seconds);
}
}

namespace ConvexificationBenchmark
{
//------------------------------------------------------------------------------
void Run(const std::string& name, vtkUnstructuredGrid* mesh, int frames)
{
  vtkNew<vtkConvexCells> tetrahedra;
  tetrahedra->SetInputData(mesh);
  tetrahedra->TetrahedraOnlyOn();
  tetrahedra->Update();
  vtkUnstructuredGrid* grid = tetrahedra->GetOutput();
  SortMeshes::AddScalar(grid);
  const double projection = TimeProjection(grid, frames);
  vtkNew<vtkMPVOVisibilitySort> plain;
  plain->ConvexifyOff();
  const double sort = TimeSort(plain, grid, frames);
  std::printf("\nConvexification of %s\n%-8s %9s %11s %9s %9s %9s\n", name.c_str(), "cuts", "cells",
    "faces/cell", "build ms", "sort ms", "frame ms");
  std::printf("%-8s %9lld %11s %9s %9.2f %9.1f\n", "MPVO",
    static_cast<long long>(grid->GetNumberOfCells()), "-", "-", 1e3 * sort,
    1e3 * (sort + projection));
  for (const int candidates : { 1, 5, 10, 20 })
  {
    vtkNew<vtkConvexifyFilter> filter;
    filter->SetInputData(grid);
    filter->SetNumberOfCandidateCuts(candidates);
    filter->Update();
    vtkNew<vtkMPVOVisibilitySort> convexified;
    const double seconds = TimeSort(convexified, filter->GetOutput(), frames);
    std::printf("%-8d %9lld %11.1f %9.1f %9.2f %9.1f\n", candidates,
      static_cast<long long>(filter->GetNumberOfImaginaryCells()),
      filter->GetFacesPerImaginaryCell(), 1e3 * filter->GetSeconds(), 1e3 * seconds,
      1e3 * (seconds + projection));
  }
}
}
