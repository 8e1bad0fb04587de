#include "InstructionSetsBenchmark.h"

#include "BenchmarkError.h"
#include "BenchmarkMapper.h"
#include "BenchmarkScene.h"
#include "FramesInTurns.h"

#include "vtkCellProjectionOracle.h"
#include "vtkUnstructuredGrid.h"

#include <hwy/targets.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

namespace
{
constexpr int ImageSize = 512;
constexpr int ErrorSize = 96;

/// Frames of one mapper by one set of instructions.
class Row
{
public:
  Row(const BenchmarkMapper& mapper, std::int64_t target, vtkUnstructuredGrid* grid)
    : Mapper(mapper)
    , Target(target)
    , Scene(mapper.Show(grid, ImageSize, false))
  {
    this->Choose();
    this->Scene->TimeFrame(0);
  }
  void JoinTurns(FramesInTurns& turns)
  {
    turns.Add(
      [this](int frame)
      {
        this->Choose();
        return this->Scene->TimeFrame(frame);
      },
      this->Seconds);
  }
  double GetMedian() const { return Median(this->Seconds); }
  BenchmarkError MeasureError(vtkUnstructuredGrid* grid, vtkCellProjectionOracle* oracle) const
  {
    this->Choose();
    return BenchmarkError::Measure(this->Mapper, grid, false, ErrorSize, oracle);
  }

  BenchmarkMapper Mapper;
  std::int64_t Target;

private:
  void Choose() const { hwy::GetChosenTarget().Update(this->Target); }

  std::unique_ptr<BenchmarkScene> Scene;
  std::vector<double> Seconds;
};

std::vector<Row> MakeRows(vtkUnstructuredGrid* grid)
{
  std::vector<Row> rows;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    rows.emplace_back(BenchmarkMapper::Tiles(), target, grid);
    rows.emplace_back(BenchmarkMapper::LitTiles(), target, grid);
  }
  rows.emplace_back(BenchmarkMapper::ProjectedTetrahedra(), rows.front().Target, grid);
  return rows;
}
}

//------------------------------------------------------------------------------
void InstructionSetsBenchmark::Run(const std::string& name, vtkUnstructuredGrid* grid, int frames)
{
  std::printf("\nTiles by sets of instructions, %s, %lld tetrahedra, smooth; largest errors at %d x %d\n"
              "%-10s %-28s %10s %10s %10s\n",
    name.c_str(), static_cast<long long>(grid->GetNumberOfCells()), ErrorSize, ErrorSize, "set", "mapper",
    "median ms", "VTK's / it", "error");
  std::vector<Row> rows = MakeRows(grid);
  FramesInTurns turns(frames);
  for (Row& row : rows)
  {
    row.JoinTurns(turns);
  }
  turns.Draw();
  vtkNew<vtkCellProjectionOracle> unlit, lit;
  for (const Row& row : rows)
  {
    const bool isOurs = &row != &rows.back();
    std::printf("%-10s %-28s %10.1f %10.2f %10.1e\n", isOurs ? hwy::TargetName(row.Target) : "",
      row.Mapper.Name.c_str(), 1e3 * row.GetMedian(), rows.back().GetMedian() / row.GetMedian(),
      row.MeasureError(grid, row.Mapper.IsLit ? lit : unlit).Maximum);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}
