#include "TilesBenchmark.h"

#include "BenchmarkMapper.h"
#include "BenchmarkScene.h"
#include "BenchmarkThreads.h"
#include "SortBenchmark.h"
#include "SortMeshes.h"
#include "ThreadHandOver.h"

#include "vtkConvexCellMapper.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeMapper.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>

namespace
{
constexpr int ImageSize = 512;
// Of ZSweep, whose frames take seconds.
constexpr int FewFrames = 3;
constexpr int LatticeOfCasters = 30;

vtkSmartPointer<vtkUnstructuredGrid> MakeLattice(int cells)
{
  const auto grid = SortBenchmark::MakeLattice(cells);
  SortMeshes::AddScalar(grid);
  return grid;
}

vtkSmartPointer<vtkUnstructuredGridVolumeMapper> MakeTiles()
{
  return BenchmarkMapper::Tiles().Make();
}

struct View
{
  int Size = ImageSize;
  int Frames = 9;
  bool IsSpiky = false;
};

// Seconds of a frame after the first; `see` is called after each.
double TimeFrames(vtkUnstructuredGridVolumeMapper* mapper, vtkUnstructuredGrid* grid,
  const View& view, const std::function<void()>& see = [] {})
{
  BenchmarkScene scene(mapper, grid, view.Size, view.IsSpiky);
  scene.TimeFrame(0);
  std::vector<double> seconds;
  for (int frame = 1; frame <= view.Frames; ++frame)
  {
    seconds.push_back(scene.TimeFrame(frame));
    see();
  }
  return Median(seconds);
}

void PrintStages(const std::string& name, vtkUnstructuredGrid* grid, const View& view)
{
  const char* const stages[] = { "SecondsPrepare", "SecondsSort", "SecondsProject", "SecondsBlend" };
  const auto mapper = MakeTiles();
  std::vector<double> seconds[4];
  const double whole = TimeFrames(mapper, grid, view,
    [&]
    {
      for (int i = 0; i < 4; ++i)
      {
        vtkTable* statistics = vtkConvexCellMapper::SafeDownCast(mapper)->GetLastStatistics();
        seconds[i].push_back(statistics->GetValueByName(0, stages[i]).ToDouble());
      }
    });
  std::printf("%-28s %-6s %9.1f", name.c_str(), view.IsSpiky ? "spiky" : "smooth", 1e3 * whole);
  for (const std::vector<double>& stage : seconds)
  {
    std::printf(" %9.2f", 1e3 * Median(stage));
  }
  std::printf("\n");
}

void CompareStages(const std::string& name, vtkUnstructuredGrid* grid, int frames)
{
  std::printf("\nTiles, where a frame's time goes, %d x %d pixels, %d frames, a new eye each\n"
              "%-28s %-6s %9s %9s %9s %9s %9s\n",
    ImageSize, ImageSize, frames, "mesh", "", "median ms", "prepare", "sort", "project", "blend");
  const auto lattice = MakeLattice(LatticeOfCasters);
  for (const bool spiky : { false, true })
  {
    PrintStages(name, grid, { ImageSize, frames, spiky });
    PrintStages("a jittered lattice", lattice, { ImageSize, frames, spiky });
  }
}

void CompareSizes(int frames)
{
  std::printf("\nTiles, ten times the cells\n%12s %9s %12s\n", "tetrahedra", "median ms", "of the first");
  double first = 0.0;
  for (const int cells : { 13, 28, 60 })
  {
    const auto grid = MakeLattice(cells);
    const double seconds = TimeFrames(MakeTiles(), grid, { ImageSize, frames });
    first = first == 0.0 ? seconds : first;
    std::printf("%12lld %9.1f %12.2f\n", static_cast<long long>(grid->GetNumberOfCells()),
      1e3 * seconds, seconds / first);
  }
}

void ComparePixels(const std::string& name, vtkUnstructuredGrid* grid, int frames)
{
  std::printf("\nTiles, four times the pixels, %s\n%12s %9s %12s\n", name.c_str(), "pixels",
    "median ms", "of the first");
  double first = 0.0;
  for (const int size : { 256, 512, 1024, 2048 })
  {
    const double seconds = TimeFrames(MakeTiles(), grid, { size, frames });
    first = first == 0.0 ? seconds : first;
    std::printf("%5d x %4d %9.1f %12.2f\n", size, size, 1e3 * seconds, seconds / first);
  }
}

// A process each: see BenchmarkThreads.
void CompareThreads(const std::string& name, int frames)
{
  const int most = vtkSMPTools::GetEstimatedNumberOfThreads();
  std::printf("\nTiles, threads, a process each, %s\n%12s %9s %12s\n", name.c_str(), "threads", "median ms", "faster");
  double first = 0.0;
  for (int threads = 1; threads <= most; threads *= 2)
  {
    const std::string answer =
      BenchmarkThreads::Ask(std::to_string(frames) + " tiles-threads " + std::to_string(threads));
    int count = 0;
    double seconds = 0.0;
    if (std::sscanf(answer.c_str(), "%d %lf", &count, &seconds) != 2 || count != threads)
    {
      std::printf("%12d left out: %d took part\n", threads, count);
      continue;
    }
    first = first == 0.0 ? seconds : first;
    std::printf("%12d %9.1f %12.2f\n", threads, 1e3 * seconds, first / seconds);
  }
}

// In turns: a machine's clock changes while the slow ones draw.
void CompareCasters(int frames)
{
  const auto grid = MakeLattice(LatticeOfCasters);
  std::printf("\nVTK's ray casters in turns, a ray for every pixel, a jittered lattice of %lld tetrahedra\n"
              "%-28s %7s %10s %8s\n",
    static_cast<long long>(grid->GetNumberOfCells()), "mapper", "frames", "median ms", "Tiles");
  const BenchmarkMapper mappers[] = { BenchmarkMapper::Tiles(), BenchmarkMapper::Bunyk(), BenchmarkMapper::ZSweep() };
  const int every[] = { 1, 1, std::max(frames / FewFrames, 1) };
  std::vector<std::unique_ptr<BenchmarkScene>> scenes;
  for (const BenchmarkMapper& mapper : mappers)
  {
    scenes.push_back(std::make_unique<BenchmarkScene>(mapper.Make(), grid, ImageSize, false));
    scenes.back()->TimeFrame(0);
  }
  std::vector<double> seconds[3];
  for (int frame = 1; frame <= frames; ++frame)
  {
    for (std::size_t i = 0; i < scenes.size(); ++i)
    {
      if (frame % every[i] == 0)
      {
        seconds[i].push_back(scenes[i]->TimeFrame(frame));
      }
    }
  }
  const double tiles = Median(seconds[0]);
  for (std::size_t i = 0; i < scenes.size(); ++i)
  {
    std::printf("%-28s %7zu %10.1f %8.1f\n", mappers[i].Name.c_str(), seconds[i].size(), 1e3 * Median(seconds[i]),
      Median(seconds[i]) / tiles);
  }
}
}

//------------------------------------------------------------------------------
void TilesBenchmark::Run(const std::string& name, vtkUnstructuredGrid* grid, int frames)
{
  ThreadHandOver::Print();
  CompareStages(name, grid, frames);
  CompareSizes(frames);
  ComparePixels(name, grid, frames);
  CompareThreads(name, frames);
  CompareCasters(frames);
}

//------------------------------------------------------------------------------
void TilesBenchmark::RunThreads(vtkUnstructuredGrid* grid, int frames, int threads)
{
  const bool isUsed = BenchmarkThreads::Use(threads);
  const double seconds = isUsed ? TimeFrames(MakeTiles(), grid, { ImageSize, frames }) : 0.0;
  // Counted once more: what was asked for must have lasted.
  std::printf("%d %.6f\n", BenchmarkThreads::Count(), seconds);
}
