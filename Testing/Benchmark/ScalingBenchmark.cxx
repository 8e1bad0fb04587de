#include "ScalingBenchmark.h"

#include "BenchmarkMachine.h"
#include "BenchmarkMapper.h"
#include "BenchmarkScene.h"
#include "BenchmarkThreads.h"
#include "FramesInTurns.h"
#include "ScalingRow.h"
#include "SortBenchmark.h"
#include "SortMeshes.h"
#include "ThreadHandOver.h"

#include "vtkCellProjectionOracle.h"
#include "vtkConvexCellMapper.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeMapper.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

namespace
{
using ScalingBenchmark::Plan;

// A first frame may take longer than another by its inverse.
constexpr double FirstFrameShare = 2.0 / 3.0;

struct Case
{
  std::string Sweep;
  int Cubes = 0;
  int Size = 0;
  bool IsSpiky = false;
  int Threads = 0;
};

// What one mapper draws of one case.
struct Run
{
  std::size_t Case = 0;
  BenchmarkMapper Mapper;
  ScalingRow Row;
  std::unique_ptr<BenchmarkScene> Scene;
};

class Scaling
{
public:
  Scaling(const Plan& plan, const BenchmarkMachine& machine, int frames, const std::string& folder)
    : With(plan)
    , Machine(machine)
    , Frames(frames)
  {
    if (!folder.empty())
    {
      this->CSV.open(folder + "/scaling.csv");
      std::cout << (this->CSV ? "" : "cannot write ") << folder << "/scaling.csv" << std::endl;
      ScalingRow::WriteHeader(this->CSV);
    }
  }

  void CompareCells();
  void ComparePixels();
  void CompareThreads();

private:
  void TakeLattice(int cubes);
  void Compare(const std::vector<Case>& cases, const std::vector<BenchmarkMapper>& mappers);
  std::vector<Run> Show(const std::vector<Case>& cases, const std::vector<BenchmarkMapper>& mappers);
  bool IsLeftOut(const ScalingRow& row, double growth) const;
  ScalingRow Begin(const Case& what, const BenchmarkMapper& mapper) const;
  void TimeFirst(Run& run) const;
  void TimeFrames(std::vector<Run>& runs) const;
  void MeasureError(const Case& what, const BenchmarkMapper& mapper, ScalingRow& row);
  void Report(const std::vector<ScalingRow>& rows);
  void PrintStages() const;

  const Plan With;
  const BenchmarkMachine Machine;
  const int Frames;
  std::ofstream CSV;
  vtkSmartPointer<vtkUnstructuredGrid> Lattice;
  int CubesOfLattice = 0;
  std::map<std::pair<int, bool>, vtkSmartPointer<vtkCellProjectionOracle>> Oracles;
  // By mesh, function, method and threads.
  std::map<std::tuple<int, bool, std::string, int>, BenchmarkError> Errors;
  // By method and function.
  std::map<std::pair<std::string, bool>, ScalingRow> Last;
  std::vector<ScalingRow> Timed;
};

//------------------------------------------------------------------------------
void Scaling::TakeLattice(int cubes)
{
  if (this->CubesOfLattice != cubes)
  {
    this->Lattice = nullptr;
    this->Lattice = SortBenchmark::MakeLattice(cubes);
    SortMeshes::AddScalar(this->Lattice);
    this->CubesOfLattice = cubes;
  }
}

//------------------------------------------------------------------------------
ScalingRow Scaling::Begin(const Case& what, const BenchmarkMapper& mapper) const
{
  ScalingRow row;
  row.Sweep = what.Sweep;
  row.Cells = this->Lattice->GetNumberOfCells();
  row.Size = what.Size;
  row.Threads = what.Threads;
  row.IsSpiky = what.IsSpiky;
  row.Method = mapper.Name;
  row.Engine = mapper.Engine;
  const double pixels = this->With.OracleLooks / static_cast<double>(row.Cells);
  row.ErrorSize = std::min(this->With.ErrorSize, 4 * static_cast<int>(std::sqrt(pixels) / 4.0));
  return row;
}

//------------------------------------------------------------------------------
bool Scaling::IsLeftOut(const ScalingRow& row, double growth) const
{
  const auto found = this->Last.find({ row.Method, row.IsSpiky });
  // Tiles are what the table is about.
  if (found == this->Last.end() || row.Engine == BenchmarkMapper::Tiles().Engine)
  {
    return false;
  }
  const ScalingRow& last = found->second;
  const double cells = static_cast<double>(row.Cells) / static_cast<double>(last.Cells);
  const double edges = static_cast<double>(row.Size) / last.Size;
  const double seconds =
    std::max(last.GetMedian(), FirstFrameShare * last.First) * std::pow(cells, growth) * edges * edges;
  if (seconds > this->With.SecondsPerFrame)
  {
    std::printf("%10lld %5d %3d %-6s %-24s left out: a frame may take %.0f s\n", row.Cells, row.Size,
      row.Threads, row.IsSpiky ? "spiky" : "smooth", row.Method.c_str(), seconds);
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
void Scaling::TimeFrames(std::vector<Run>& runs) const
{
  // As many frames as were asked for: the table says how many.
  FramesInTurns turns(this->Frames, 0.0);
  for (Run& run : runs)
  {
    turns.Add(
      [&run](int frame)
      {
        BenchmarkThreads::Set(run.Row.Threads);
        return run.Scene->TimeFrame(frame);
      },
      run.Row.Frames, this->With.SecondsPerRow);
  }
  turns.Draw();
}

//------------------------------------------------------------------------------
void Scaling::MeasureError(const Case& what, const BenchmarkMapper& mapper, ScalingRow& row)
{
  // The image is of one size, whatever the row's.
  const auto [error, isNew] =
    this->Errors.try_emplace({ what.Cubes, what.IsSpiky, mapper.Name, row.Threads });
  if (!isNew)
  {
    row.Error = error->second;
    return;
  }
  auto& oracle = this->Oracles[{ what.Cubes, what.IsSpiky }];
  if (!oracle)
  {
    oracle = vtkSmartPointer<vtkCellProjectionOracle>::New();
  }
  row.Error = BenchmarkError::Measure(mapper, this->Lattice, what.IsSpiky, row.ErrorSize, oracle);
  // Its image serves the rows to come, without the mesh.
  oracle->SetInputData(nullptr);
  error->second = row.Error;
}

//------------------------------------------------------------------------------
void Scaling::TimeFirst(Run& run) const
{
  BenchmarkThreads::Set(run.Row.Threads);
  run.Row.First = run.Scene->TimeFrame(0);
  if (auto* ours = vtkConvexCellMapper::SafeDownCast(run.Scene->Volume->GetMapper()))
  {
    run.Row.Prepare = ours->GetLastStatistics()->GetValueByName(0, "SecondsPrepare").ToDouble();
  }
}

// A mapper's cases follow each other, so that their frames are compared as soon as they are drawn.
std::vector<Run> Scaling::Show(const std::vector<Case>& cases, const std::vector<BenchmarkMapper>& mappers)
{
  std::vector<Run> runs;
  for (const BenchmarkMapper& mapper : mappers)
  {
    for (std::size_t i = 0; i < cases.size(); ++i)
    {
      const ScalingRow row = this->Begin(cases[i], mapper);
      if (!this->IsLeftOut(row, mapper.Growth))
      {
        runs.push_back({ i, mapper, row, mapper.Show(this->Lattice, cases[i].Size, cases[i].IsSpiky) });
        this->TimeFirst(runs.back());
        this->Last[{ row.Method, row.IsSpiky }] = runs.back().Row;
      }
    }
  }
  return runs;
}

// Cases of one mesh.
void Scaling::Compare(const std::vector<Case>& cases, const std::vector<BenchmarkMapper>& mappers)
{
  this->TakeLattice(cases.front().Cubes);
  std::vector<Run> runs = this->Show(cases, mappers);
  this->TimeFrames(runs);
  std::vector<std::vector<ScalingRow>> rows(cases.size());
  for (Run& run : runs)
  {
    BenchmarkThreads::Set(run.Row.Threads);
    run.Row.Stages = FrameStages::Measure(*run.Scene, static_cast<int>(run.Row.Frames.size()));
    run.Scene.reset();
    this->MeasureError(cases[run.Case], run.Mapper, run.Row);
    rows[run.Case].push_back(run.Row);
  }
  for (const std::vector<ScalingRow>& each : rows)
  {
    this->Report(each);
  }
}

//------------------------------------------------------------------------------
void Scaling::Report(const std::vector<ScalingRow>& rows)
{
  const auto peer = std::find_if(rows.begin(), rows.end(), [](const ScalingRow& row)
    { return row.Method == BenchmarkMapper::ProjectedTetrahedra().Name; });
  for (ScalingRow row : rows)
  {
    row.Reference = peer != rows.end() ? peer->GetMedian() : 0.0;
    row.Print();
    if (this->CSV.is_open())
    {
      row.Write(this->CSV, this->Machine);
    }
    this->Last[{ row.Method, row.IsSpiky }] = row;
    if (row.Stages.IsMeasured())
    {
      this->Timed.push_back(row);
    }
  }
}

//------------------------------------------------------------------------------
void Scaling::CompareCells()
{
  std::printf("\nAgainst cells\n");
  ScalingRow::PrintHeader();
  // Of the largest mesh there is no room for two: one by one.
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  for (const int cubes : this->With.Cubes)
  {
    this->Compare({ { "cells", cubes, this->With.Size, false, threads } },
      { BenchmarkMapper::Tiles(), BenchmarkMapper::Raster(), BenchmarkMapper::ProjectedTetrahedra(),
        BenchmarkMapper::Bunyk(), BenchmarkMapper::ZSweep() });
    this->Compare({ { "cells", cubes, this->With.Size, true, threads } },
      { BenchmarkMapper::Tiles(), BenchmarkMapper::Raster(), BenchmarkMapper::ProjectedTetrahedra() });
  }
}

//------------------------------------------------------------------------------
void Scaling::ComparePixels()
{
  std::printf("\nAgainst pixels\n");
  ScalingRow::PrintHeader();
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  std::vector<Case> cases;
  for (const int size : this->With.Sizes)
  {
    cases.push_back({ "pixels", this->With.CubesOfPixels, size, false, threads });
  }
  this->Compare(cases, { BenchmarkMapper::Tiles(), BenchmarkMapper::Raster(), BenchmarkMapper::ProjectedTetrahedra(),
    BenchmarkMapper::Bunyk(), BenchmarkMapper::ZSweep() });
}

//------------------------------------------------------------------------------
void Scaling::CompareThreads()
{
  std::printf("\nAgainst threads\n");
  ScalingRow::PrintHeader();
  const int most = vtkSMPTools::GetEstimatedNumberOfThreads();
  const bool isTurned = std::atoi(BenchmarkThreads::Ask("0 threads-turn " + std::to_string(most)).c_str()) == 1;
  if (!isTurned && most > 1)
  {
    std::printf("fewer than %d threads left out: a process cannot change their number and back here; the section "
                "tiles takes a process each\n",
      most);
  }
  for (const bool spiky : { false, true })
  {
    std::vector<Case> cases;
    for (int threads = isTurned ? 1 : most; threads <= most; threads = threads < most ? std::min(2 * threads, most) : most + 1)
    {
      cases.push_back({ "threads", this->With.CubesOfThreads, this->With.Size, spiky, threads });
    }
    this->Compare(cases, { BenchmarkMapper::Tiles() });
  }
  BenchmarkThreads::Set(most);
  this->PrintStages();
}

//------------------------------------------------------------------------------
void Scaling::PrintStages() const
{
  std::printf("\nTiles, ns per tetrahedron in each stage, of the median of as many frames again that are "
              "timed; within tiles, from Order on, the mean of all threads; rest: driver, depth, blending; "
              "cover, shade: lane use\n");
  ScalingRow::PrintStagesHeader();
  for (const ScalingRow& row : this->Timed)
  {
    row.PrintStages();
  }
}

void PrintHeading(const BenchmarkMachine& machine, const Plan& plan, int frames)
{
  std::printf("\nScaling of jittered lattices of tetrahedra; %s\n", machine.Describe().c_str());
  std::printf("up to %d frames, a new eye each; errors at %d x %d pixels, where the oracle "
              "would look at more than %.1e cells in all at fewer; of VTK's mappers in 8 bits without alpha; a mapper is "
              "left out where a frame may take more than %.0f s\n",
    frames, plan.ErrorSize, plan.ErrorSize, plan.OracleLooks, plan.SecondsPerFrame);
  ThreadHandOver::Print();
}
}

//------------------------------------------------------------------------------
ScalingBenchmark::Plan ScalingBenchmark::Full()
{
  return { { 15, 30, 60, 126 }, { 256, 512, 1024, 2048 }, 30, 60, 512, 96, 4e9, 10.0, 4.0 };
}

//------------------------------------------------------------------------------
ScalingBenchmark::Plan ScalingBenchmark::Tiny()
{
  return { { 4 }, { 32, 64 }, 4, 4, 64, 32, 4e9, 10.0, 100.0 };
}

//------------------------------------------------------------------------------
void ScalingBenchmark::Run(const Plan& plan, int frames, const std::string& folder)
{
  const BenchmarkMachine machine = BenchmarkMachine::Find();
  PrintHeading(machine, plan, frames);
  Scaling scaling(plan, machine, frames, folder);
  scaling.CompareCells();
  scaling.ComparePixels();
  scaling.CompareThreads();
}
