#include "TilesBenchmark.h"

#include "BenchmarkMapper.h"
#include "BenchmarkScene.h"
#include "BenchmarkThreads.h"
#include "FramesInTurns.h"
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
#include <iterator>
#include <memory>

namespace
{
constexpr int ImageSize = 512;
constexpr int LatticeOfCasters = 30;
// Of a number of threads.
constexpr int Processes = 3;

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

struct Case
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  int Size = ImageSize;
  BenchmarkMapper Mapper = BenchmarkMapper::Tiles();
};

// Seconds of the frames after the first.
std::vector<std::vector<double>> TimeInTurns(const std::vector<Case>& cases, int frames)
{
  std::vector<std::unique_ptr<BenchmarkScene>> scenes;
  std::vector<std::vector<double>> seconds(cases.size());
  FramesInTurns turns(frames);
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    BenchmarkScene* scene = scenes.emplace_back(cases[i].Mapper.Show(cases[i].Grid, cases[i].Size, false)).get();
    scene->TimeFrame(0);
    turns.Add([scene](int frame) { return scene->TimeFrame(frame); }, seconds[i]);
  }
  turns.Draw();
  return seconds;
}

std::vector<double> MedianInTurns(const std::vector<Case>& cases, int frames)
{
  const std::vector<std::vector<double>> seconds = TimeInTurns(cases, frames);
  std::vector<double> medians;
  std::transform(seconds.begin(), seconds.end(), std::back_inserter(medians), Median);
  return medians;
}

void CompareSizes(int frames)
{
  std::vector<Case> cases;
  for (const int cells : { 13, 28, 60 })
  {
    cases.push_back({ MakeLattice(cells) });
  }
  const std::vector<double> seconds = MedianInTurns(cases, frames);
  std::printf("\nTiles, ten times the cells, in turns\n%12s %9s %12s\n", "tetrahedra", "median ms", "of the first");
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    std::printf("%12lld %9.1f %12.2f\n", static_cast<long long>(cases[i].Grid->GetNumberOfCells()),
      1e3 * seconds[i], seconds[i] / seconds[0]);
  }
}

void ComparePixels(const std::string& name, vtkUnstructuredGrid* grid, int frames)
{
  std::vector<Case> cases;
  for (const int size : { 256, 512, 1024, 2048 })
  {
    cases.push_back({ grid, size });
  }
  const std::vector<double> seconds = MedianInTurns(cases, frames);
  std::printf("\nTiles, four times the pixels, in turns, %s\n%12s %9s %12s\n", name.c_str(), "pixels",
    "median ms", "of the first");
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    std::printf("%5d x %4d %9.1f %12.2f\n", cases[i].Size, cases[i].Size, 1e3 * seconds[i], seconds[i] / seconds[0]);
  }
}

// Seconds of a frame in a process of its own; none where other than that many threads took part.
double AskThreads(int frames, int threads)
{
  const std::string answer =
    BenchmarkThreads::Ask(std::to_string(frames) + " tiles-threads " + std::to_string(threads));
  int count = 0;
  double seconds = 0.0;
  const bool isAnswered = std::sscanf(answer.c_str(), "%d %lf", &count, &seconds) == 2 && count == threads;
  return isAnswered ? seconds : 0.0;
}

// A process each: see BenchmarkThreads.
void CompareThreads(const std::string& name, int frames)
{
  std::vector<int> counts;
  for (int threads = 1; threads <= vtkSMPTools::GetEstimatedNumberOfThreads(); threads *= 2)
  {
    counts.push_back(threads);
  }
  std::vector<std::vector<double>> seconds(counts.size());
  FramesInTurns turns(Processes, 0.0);
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    turns.Add([frames, threads = counts[i]](int) { return AskThreads(frames, threads); }, seconds[i]);
  }
  turns.Draw();
  std::printf("\nTiles, threads, %d processes each in turns, %s\n%12s %9s %12s\n", Processes, name.c_str(), "threads",
    "median ms", "faster");
  const double first = Median(seconds.front());
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const double median = Median(seconds[i]);
    std::printf(median > 0.0 ? "%12d %9.1f %12.2f\n" : "%12d left out: others took part\n", counts[i], 1e3 * median,
      first / median);
  }
}

void CompareCasters(int frames)
{
  const auto grid = MakeLattice(LatticeOfCasters);
  const std::vector<Case> cases = { { grid, ImageSize, BenchmarkMapper::Tiles() },
    { grid, ImageSize, BenchmarkMapper::Bunyk() }, { grid, ImageSize, BenchmarkMapper::ZSweep() } };
  const std::vector<std::vector<double>> seconds = TimeInTurns(cases, frames);
  std::printf("\nVTK's ray casters in turns, a ray for every pixel, a jittered lattice of %lld tetrahedra\n"
              "%-28s %7s %10s %8s\n",
    static_cast<long long>(grid->GetNumberOfCells()), "mapper", "frames", "median ms", "Tiles");
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const double median = Median(seconds[i]);
    std::printf("%-28s %7d %10.1f %8.1f\n", cases[i].Mapper.Name.c_str(), static_cast<int>(seconds[i].size()),
      1e3 * median, median / Median(seconds[0]));
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
