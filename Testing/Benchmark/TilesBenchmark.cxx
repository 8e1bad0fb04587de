#include "TilesBenchmark.h"

#include "BenchmarkScene.h"
#include "SortBenchmark.h"
#include "SortMeshes.h"

#include "vtkPreIntegratedTetrahedraMapper.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"
#include "vtkUnstructuredGridVolumeZSweepMapper.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>

namespace
{
constexpr int ImageSize = 512;
// A frame of ZSweep takes seconds.
constexpr int SweepFrames = 3;

vtkSmartPointer<vtkUnstructuredGrid> MakeLattice(int cells)
{
  const auto grid = SortBenchmark::MakeLattice(cells);
  SortMeshes::AddScalar(grid);
  return grid;
}

vtkSmartPointer<vtkPreIntegratedTetrahedraMapper> MakeTiles()
{
  auto mapper = vtkSmartPointer<vtkPreIntegratedTetrahedraMapper>::New();
  mapper->SetEngineToTiles();
  return mapper;
}

template <class RayCaster>
vtkSmartPointer<RayCaster> MakeRayCaster()
{
  auto mapper = vtkSmartPointer<RayCaster>::New();
  // A ray for every pixel, as Tiles.
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(1.0f);
  return mapper;
}

// After a first frame, of which `see` is told.
double MedianOf(vtkUnstructuredGridVolumeMapper* mapper, vtkUnstructuredGrid* grid, int size,
  int frames, bool spiky = false, const std::function<void()>& see = [] {})
{
  BenchmarkScene scene(mapper, grid, size, spiky);
  scene.TimeFrame(0);
  std::vector<double> seconds;
  for (int frame = 1; frame <= frames; ++frame)
  {
    seconds.push_back(scene.TimeFrame(frame));
    see();
  }
  std::vector<double> c=seconds; std::sort(c.begin(),c.end()); std::fprintf(stderr,"MIN %.2f Q1 %.2f\n",1e3*c[0],1e3*c[c.size()/4]);
  return Median(seconds);
}

void PrintStages(const std::string& name, vtkUnstructuredGrid* grid, int frames)
{
  const char* const stages[] = { "SecondsPrepare", "SecondsSort", "SecondsProject", "SecondsBlend" };
  for (const bool spiky : { getenv("SPIKY") != nullptr })
  {
    const auto mapper = MakeTiles();
    std::vector<double> seconds[4];
    const double whole = MedianOf(mapper, grid, ImageSize, frames, spiky,
      [&]
      {
        for (int i = 0; i < 4; ++i)
        {
          vtkTable* statistics = mapper->GetLastStatistics();
          seconds[i].push_back(statistics->GetValueByName(0, stages[i]).ToDouble());
        }
      });
    std::printf("%-28s %-6s %9.1f", name.c_str(), spiky ? "spiky" : "smooth", 1e3 * whole);
    for (const std::vector<double>& stage : seconds)
    {
      std::printf(" %9.1f", 1e3 * Median(stage));
    }
    std::printf("\n");
  }
}
}

//------------------------------------------------------------------------------
void TilesBenchmark::Run(const std::string& name, vtkUnstructuredGrid* grid, int frames)
{
  std::printf("\nTiles, where a frame's time goes, %d x %d pixels, %d frames, a new eye each\n"
              "%-28s %-6s %9s %9s %9s %9s %9s\n",
    ImageSize, ImageSize, frames, "mesh", "", "median ms", "prepare", "sort", "project", "blend");
  if (getenv("LAT")) PrintStages("lattice", MakeLattice(32), frames); else PrintStages(name, grid, frames);
}
