#include "CellsBenchmark.h"

#include "BenchmarkScene.h"
#include "CellZoo.h"
#include "SortMeshes.h"

#include "vtkConvexCells.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <vector>

namespace
{
void Measure(const std::string& name, vtkUnstructuredGrid* grid, bool tetrahedraOnly, int frames)
{
  std::vector<double> seconds, processor; // of all threads together
  vtkIdType cells = 0;
  for (int frame = 0; frame < frames; ++frame)
  {
    vtkNew<vtkConvexCells> filter;
    filter->SetInputData(grid);
    filter->SetTetrahedraOnly(tetrahedraOnly);
    const std::clock_t clock = std::clock();
    const auto begin = std::chrono::steady_clock::now();
    filter->Update();
    seconds.push_back(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    processor.push_back(static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC);
    cells = filter->GetOutput()->GetNumberOfCells();
  }
  const double median = Median(seconds);
  std::printf("%-20s %-12s %10lld %10lld %9.1f %9.1f %9.2f\n", name.c_str(),
    tetrahedraOnly ? "tetrahedra" : "convex cells",
    static_cast<long long>(grid->GetNumberOfCells()), static_cast<long long>(cells), 1e3 * median,
    1e3 * Median(processor), 1e-6 * cells / median);
}
}

//------------------------------------------------------------------------------
void CellsBenchmark::Run(int cubes, int frames)
{
  const int size[3] = { cubes, cubes, cubes };
  std::vector<int> kinds(static_cast<std::size_t>(cubes) * cubes * cubes);
  for (std::size_t cube = 0; cube < kinds.size(); ++cube)
  {
    kinds[cube] = static_cast<int>(cube * 7 / 3 % (CellZoo::Pyramids + 1));
  }
  const auto field = [](const double x[3]) { return x[0]; };
  std::printf("%-20s %-12s %10s %10s %9s %9s %9s\n", "mesh", "out as", "cells in", "cells out",
    "median ms", "CPU ms", "M cells/s");
  for (const bool tetrahedraOnly : { false, true })
  {
    Measure("hexahedra", SortMeshes::JitteredLattice(cubes, 0.1), tetrahedraOnly, frames);
  }
  // Without the points that no cell uses.
  const auto mixed =
    SortMeshes::Select(CellZoo::Make(size, kinds, field), [](vtkIdType) { return true; });
  for (const bool tetrahedraOnly : { false, true })
  {
    Measure("five kinds", mixed, tetrahedraOnly, frames);
  }
}
