// Mappers: ours by both engines and VTK's projected tetrahedra on the same meshes, views and
// transfer functions, frames in turns, each one's error against the float64 oracle in the same
// row. Scaling: the same and VTK's ray casters against cells, pixels and threads, with the stages of
// Tiles, as CSV. Tiles: stages, sizes, pixels, threads, ray casters. Sorts: every visibility sort on the same
// meshes and eyes. Cuts: what convexification costs and gives. Hexahedra: the mappers that draw
// cells as they are, beside those of tetrahedra. Simplification: levels of a mesh, as CSV. Cells:
// what vtkConvexCells takes. Shells: the paper's tables. Surfaces: iso-surfaces of moving meshes
// beside contours.
//   CellProjectionBenchmark [frames [SECTION [FOLDER]]]; one of mappers, scaling, scaling-tiny, tiles,
//   sorts, cuts, hexahedra, simplification, cells, shells, surfaces, or all; scaling.csv goes to the
//   folder; the data's folder is in CELLPROJECTION_DATA

#include "BenchmarkError.h"
#include "BenchmarkMapper.h"
#include "BenchmarkScene.h"
#include "BenchmarkThreads.h"
#include "CellsBenchmark.h"
#include "ConvexificationBenchmark.h"
#include "FramesInTurns.h"
#include "HexahedraBenchmark.h"
#include "InstructionSetsBenchmark.h"
#include "IsoBenchmark.h"
#include "RealMeshes.h"
#include "ScalingBenchmark.h"
#include "ShellBenchmark.h"
#include "SimplificationBenchmark.h"
#include "SortBenchmark.h"
#include "SortMeshes.h"
#include "ThreadHandOver.h"
#include "TilesBenchmark.h"

#include "vtkCellProjectionOracle.h"
#include "vtkConvexCellMapper.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace
{
constexpr int ImageSize = 512;
// The oracle visits every cell for every pixel: a smaller picture of the same view will do.
constexpr int ErrorSize = 96;

struct Row
{
  std::string Name;
  double First = 0.0;
  double Prepare = 0.0;
  std::vector<double> Seconds;
  BenchmarkError Error;
};

std::vector<BenchmarkMapper> Contenders()
{
  return { BenchmarkMapper::Tiles(), BenchmarkMapper::LitTiles(), BenchmarkMapper::Raster(),
    BenchmarkMapper::ProjectedTetrahedra() };
}

void MeasureSpeed(const std::vector<BenchmarkMapper>& contenders, vtkUnstructuredGrid* grid, bool spiky,
  int frames, std::vector<Row>& rows)
{
  std::vector<std::unique_ptr<BenchmarkScene>> scenes;
  FramesInTurns turns(frames);
  for (size_t i = 0; i < contenders.size(); ++i)
  {
    BenchmarkScene* scene = scenes.emplace_back(contenders[i].Show(grid, ImageSize, spiky)).get();
    turns.Add([scene](int frame) { return scene->TimeFrame(frame); }, rows[i].Seconds);
    rows[i].First = scene->TimeFrame(0);
    if (auto* ours = vtkConvexCellMapper::SafeDownCast(scene->Volume->GetMapper()))
    {
      rows[i].Prepare = ours->GetLastStatistics()->GetValueByName(0, "SecondsPrepare").ToDouble();
    }
  }
  turns.Draw();
}

void Print(const Row& row, double peer, vtkIdType cells)
{
  const double median = Median(row.Seconds);
  std::printf("%-28s %9.1f %9.1f %9.1f %8.2f %7.2f %9.2e %9.2e %9.2e %7.1f\n", row.Name.c_str(),
    1e3 * median, 1e3 * row.First, 1e3 * row.Prepare, 1e-6 * cells / median, peer / median,
    row.Error.RootMeanSquare, row.Error.Percentile, row.Error.Maximum, 100.0 * row.Error.Share);
}

void CompareMappers(const BenchmarkMesh& mesh, bool spiky, int frames)
{
  const vtkIdType cells = mesh.Grid->GetNumberOfCells();
  std::printf("%s, %s, %lld tetrahedra, %d x %d pixels, %d frames or more, a new eye each; errors at "
              "%d x %d\n",
    mesh.Name.c_str(), spiky ? "spiky" : "smooth", static_cast<long long>(cells), ImageSize,
    ImageSize, frames, ErrorSize, ErrorSize);
  const std::vector<BenchmarkMapper> contenders = Contenders();
  std::vector<Row> rows(contenders.size());
  MeasureSpeed(contenders, mesh.Grid, spiky, frames, rows);
  vtkNew<vtkCellProjectionOracle> unlit, lit;
  std::printf("%-28s %9s %9s %9s %8s %7s %9s %9s %9s %7s\n", "mapper", "median ms", "first ms",
    "prepare", "Mtets/s", "ratio", "RMSE", "99.9 %", "maximum", "% > .5");
  for (size_t i = 0; i < contenders.size(); ++i)
  {
    rows[i].Name = contenders[i].Name;
    rows[i].Error = BenchmarkError::Measure(
      contenders[i], mesh.Grid, spiky, ErrorSize, contenders[i].IsLit ? lit : unlit);
    Print(rows[i], Median(rows.back().Seconds), cells);
  }
}

void CompareMappersOnMeshes(const BenchmarkMesh& mesh, int frames)
{
  std::vector<BenchmarkMesh> meshes{ mesh };
  for (const int cells : { 32, 62 })
  {
    meshes.push_back({ "a jittered lattice", SortBenchmark::MakeLattice(cells) });
    SortMeshes::AddScalar(meshes.back().Grid);
  }
  for (const BenchmarkMesh& each : meshes)
  {
    CompareMappers(each, false, frames);
    CompareMappers(each, true, frames);
  }
}

void CompareSorts(const BenchmarkMesh& mesh, int frames)
{
  ThreadHandOver::Print();
  SortBenchmark benchmark;
  benchmark.Run(mesh.Name, mesh.Grid, frames);
  benchmark.Run("a jittered lattice", SortBenchmark::MakeLattice(60), frames);
}

void CompareCuts(int frames)
{
  ConvexificationBenchmark::Run("two gears", SortMeshes::Gears(), frames);
  for (const char* name : { "bluntFin", "diskOut", "can" })
  {
    if (const auto mesh = RealMeshes::Read(name))
    {
      ConvexificationBenchmark::Run(name, mesh, frames);
    }
  }
}

void CompareLevels(const BenchmarkMesh& mesh, const std::string& folder, int frames)
{
  SimplificationBenchmark::PrintHeader();
  if (const auto bucky = ReadBuckyBall(folder))
  {
    SimplificationBenchmark("Bucky ball", CutToTetrahedra(bucky)).Run({ 0.02, 0.05, 0.1 }, frames);
  }
  SimplificationBenchmark(mesh.Name, mesh.Grid).Run({ 0.02, 0.04, 0.06 }, frames);
}

void CompareInstructions(const BenchmarkMesh& mesh, int frames)
{
  InstructionSetsBenchmark::Run(mesh.Name, mesh.Grid, frames);
  const auto lattice = SortBenchmark::MakeLattice(32);
  SortMeshes::AddScalar(lattice);
  InstructionSetsBenchmark::Run("a jittered lattice", lattice, frames);
}

// The sizes of the paper's meshes.
std::vector<BenchmarkMesh> MakePaperMeshes(const BenchmarkMesh& mesh)
{
  std::vector<BenchmarkMesh> meshes = { mesh };
  for (const int size : { 20, 32, 64 })
  {
    const auto lattice = SortBenchmark::MakeLattice(size);
    SortMeshes::AddScalar(lattice);
    meshes.push_back({ "lattice of " + std::to_string(size) + "^3", lattice });
  }
  return meshes;
}

void CompareShells(const BenchmarkMesh& mesh, int frames)
{
  const int samples[4] = { 400, 300, 400, 500 };
  const std::vector<BenchmarkMesh> meshes = MakePaperMeshes(mesh);
  for (size_t i = 0; i < meshes.size(); ++i)
  {
    ShellBenchmark::Run(meshes[i].Name, meshes[i].Grid, samples[i], frames);
  }
}

void CompareSurfaces(const BenchmarkMesh& mesh, int frames)
{
  for (const BenchmarkMesh& each : MakePaperMeshes(mesh))
  {
    IsoBenchmark::Run(each.Name, each.Grid, frames);
  }
}
}

int main(int argc, char* argv[])
{
  const char* folder = std::getenv("CELLPROJECTION_DATA");
  const int frames = argc > 1 ? std::atoi(argv[1]) : 9;
  const std::string name = argc > 2 ? argv[2] : "all";
  const std::string section = name == "all" ? "" : name;
  // What BenchmarkThreads asks of a process of its own.
  if (section == "threads-turn")
  {
    std::printf("%d\n", argc > 3 && BenchmarkThreads::Turn(std::atoi(argv[3])) ? 1 : 0);
    return EXIT_SUCCESS;
  }
  const bool isScaling = section == "scaling" || section == "scaling-tiny";
  const BenchmarkMesh mesh = isScaling ? BenchmarkMesh() : LoadBenchmarkMesh(folder ? folder : "");
  if (section == "tiles-threads")
  {
    TilesBenchmark::RunThreads(mesh.Grid, frames, argc > 3 ? std::atoi(argv[3]) : 1);
  }
  if (section.empty() || section == "mappers")
  {
    CompareMappersOnMeshes(mesh, frames);
  }
  if (section.empty() || isScaling)
  {
    ScalingBenchmark::Run(section == "scaling-tiny" ? ScalingBenchmark::Tiny() : ScalingBenchmark::Full(),
      frames, argc > 3 ? argv[3] : "");
  }
  if (section.empty() || section == "tiles")
  {
    TilesBenchmark::Run(mesh.Name, mesh.Grid, frames);
  }
  if (section.empty() || section == "instructions")
  {
    CompareInstructions(mesh, frames);
  }
  if (section.empty() || section == "sorts")
  {
    CompareSorts(mesh, frames);
  }
  if (section.empty() || section == "cuts")
  {
    CompareCuts(frames);
  }
  if (section.empty() || section == "hexahedra")
  {
    const BenchmarkMesh hexahedra = LoadBenchmarkHexahedra(folder ? folder : "");
    HexahedraBenchmark(hexahedra.Name, hexahedra.Grid).Run(frames);
  }
  if (section.empty() || section == "simplification")
  {
    CompareLevels(mesh, folder ? folder : "", frames);
  }
  if (section.empty() || section == "cells")
  {
    CellsBenchmark::Run(100, frames);
  }
  if (section.empty() || section == "shells")
  {
    CompareShells(mesh, frames);
  }
  if (section.empty() || section == "surfaces")
  {
    CompareSurfaces(mesh, frames);
  }
  return EXIT_SUCCESS;
}
