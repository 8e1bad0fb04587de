#include "ScalingRow.h"

#include "BenchmarkMachine.h"
#include "BenchmarkScene.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace
{
std::string Number(double value, const char* format = "%.4g")
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

// SetUp: set_up_ns.
std::string ColumnOf(const std::string& stage)
{
  std::string column;
  for (const char letter : stage)
  {
    const bool begins = std::isupper(static_cast<unsigned char>(letter)) != 0;
    column += begins && !column.empty() ? "_" : "";
    column += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return column + "_ns";
}
}

//------------------------------------------------------------------------------
double ScalingRow::GetMedian() const
{
  return Median(this->Frames);
}

//------------------------------------------------------------------------------
double ScalingRow::GetNanosecondsPerCell(double seconds) const
{
  return 1e9 * seconds / static_cast<double>(this->Cells);
}

//------------------------------------------------------------------------------
void ScalingRow::WriteHeader(std::ostream& stream)
{
  stream << "sweep,cells,width,height,threads,transfer,method,engine,frames,median_ms,first_ms,"
            "prepare_ms,mcells_per_s,ratio_to_vtk,timed_ms";
  for (const char* stage : FrameStages::GetNames())
  {
    stream << "," << ColumnOf(stage);
  }
  stream << ",rest_ns,fragments,fragments_per_s,cells_in_tiles,cover_lane_use,shade_lane_use,"
            "mesh_bytes_per_cell,frame_bytes_per_cell,repaired_pixels,error_size,rmse,p999,maximum,"
            "share_above_half_level,renderer,processor,smp_backend,vtk"
         << std::endl;
}

//------------------------------------------------------------------------------
void ScalingRow::Write(std::ostream& stream, const BenchmarkMachine& machine) const
{
  const double median = this->GetMedian();
  const double cells = static_cast<double>(this->Cells);
  const std::string size = std::to_string(this->Size);
  std::vector<std::string> columns{ this->Sweep, std::to_string(this->Cells), size, size,
    std::to_string(this->Threads), this->IsSpiky ? "spiky" : "smooth", '"' + this->Method + '"',
    this->Engine, std::to_string(this->Frames.size()), Number(1e3 * median),
    Number(1e3 * this->First), Number(1e3 * this->Prepare), Number(1e-6 * cells / median),
    this->Reference > 0.0 ? Number(this->Reference / median) : "" };
  const FrameStages& stages = this->Stages;
  std::vector<double> timed{ 1e3 * stages.Whole };
  for (const double seconds : stages.Seconds)
  {
    timed.push_back(this->GetNanosecondsPerCell(seconds));
  }
  for (const double value : { this->GetNanosecondsPerCell(stages.GetRest()), stages.Fragments,
         stages.Fragments / median, stages.CellsInTiles, stages.CoverLaneUse, stages.ShadeLaneUse,
         stages.BytesOfMesh / cells, stages.BytesOfFrame / cells, stages.RepairedPixels })
  {
    timed.push_back(value);
  }
  timed.resize(10 + FrameStages::GetNames().size());
  for (const double value : timed)
  {
    columns.push_back(stages.IsMeasured() ? Number(value, "%.6g") : "");
  }
  for (const std::string& value : { std::to_string(this->ErrorSize), Number(this->Error.RootMeanSquare),
         Number(this->Error.Percentile), Number(this->Error.Maximum), Number(this->Error.Share),
         '"' + machine.Renderer + '"', '"' + machine.Processor + '"', machine.Backend, machine.VTK })
  {
    columns.push_back(value);
  }
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    stream << (i > 0 ? "," : "") << columns[i];
  }
  stream << std::endl;
}

//------------------------------------------------------------------------------
void ScalingRow::PrintHeader()
{
  std::printf("%10s %5s %3s %-6s %-24s %6s %9s %9s %9s %8s %7s %8s %9s %5s %9s %9s\n", "tetrahedra",
    "size", "thr", "", "method", "frames", "median ms", "first ms", "prepare", "ns/cell", "ratio",
    "Mfrag/s", "error at", "", "RMSE", "maximum");
}

//------------------------------------------------------------------------------
void ScalingRow::Print() const
{
  const double median = this->GetMedian();
  std::printf("%10lld %5d %3d %-6s %-24s %6d %9.1f %9.1f %9.1f %8.1f ", this->Cells, this->Size,
    this->Threads, this->IsSpiky ? "spiky" : "smooth", this->Method.c_str(),
    static_cast<int>(this->Frames.size()), 1e3 * median, 1e3 * this->First, 1e3 * this->Prepare,
    this->GetNanosecondsPerCell(median));
  std::printf("%7s %8s %9d^2    %9.1e %9.1e\n",
    this->Reference > 0.0 ? Number(this->Reference / median, "%.2f").c_str() : "",
    this->Stages.IsMeasured() ? Number(1e-6 * this->Stages.Fragments / median, "%.0f").c_str() : "",
    this->ErrorSize, this->Error.RootMeanSquare, this->Error.Maximum);
  std::fflush(stdout);
}

//------------------------------------------------------------------------------
void ScalingRow::PrintStagesHeader()
{
  std::printf("%10s %5s %3s %-6s", "tetrahedra", "size", "thr", "");
  for (const char* stage : FrameStages::GetNames())
  {
    std::printf(" %9s", stage);
  }
  std::printf(" %6s %8s %6s %6s %6s %6s %6s %9s\n", "rest", "timed ms", "Mfrags", "cover", "shade",
    "B last", "B frm", "maximum");
}

//------------------------------------------------------------------------------
void ScalingRow::PrintStages() const
{
  if (!this->Stages.IsMeasured())
  {
    return;
  }
  std::printf("%10lld %5d %3d %-6s", this->Cells, this->Size, this->Threads,
    this->IsSpiky ? "spiky" : "smooth");
  for (const double seconds : this->Stages.Seconds)
  {
    std::printf(" %9.2f", this->GetNanosecondsPerCell(seconds));
  }
  const double cells = static_cast<double>(this->Cells);
  std::printf(" %6.1f %8.1f %6.1f %6.2f %6.2f %6.1f %6.1f %9.1e\n",
    this->GetNanosecondsPerCell(this->Stages.GetRest()), 1e3 * this->Stages.Whole,
    1e-6 * this->Stages.Fragments, this->Stages.CoverLaneUse, this->Stages.ShadeLaneUse,
    this->Stages.BytesOfMesh / cells, this->Stages.BytesOfFrame / cells, this->Error.Maximum);
}
