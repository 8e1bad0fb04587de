#include "HexahedraBenchmark.h"

#include "FramesInTurns.h"

#include "vtkCellProjectionOracle.h"
#include "vtkConvexCellMapper.h"
#include "vtkConvexCells.h"
#include "vtkImageData.h"
#include "vtkMaximumProjectionMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPreIntegratedTetrahedraMapper.h"
#include "vtkProjectedPolyhedraMapper.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace
{
constexpr int ImageSize = 512;
// The oracle visits every cell for every pixel: a smaller picture of the same view will do.
constexpr int ErrorSize = 96;

const char* const OnePass = "one pass";
const char* const ThreePasses = "three passes";
const char* const Maximum = "maximum";
const char* const OurTetrahedra = "our tetrahedra";
const char* const OnTiles = ", Tiles";
const char* const TheirTetrahedra = "VTK projected tetrahedra";

constexpr int Raster = vtkConvexCellMapper::RASTER;
constexpr int Tiles = vtkConvexCellMapper::TILES;

vtkSmartPointer<vtkProjectedPolyhedraMapper> MakePolyhedra(
  int passes, bool average, int engine = Raster)
{
  auto mapper = vtkSmartPointer<vtkProjectedPolyhedraMapper>::New();
  mapper->SetEngine(engine);
  mapper->SetPasses(passes);
  mapper->SetAverageEmission(average);
  return mapper;
}

template <class Mapper>
vtkSmartPointer<Mapper> MakeMapper(int engine)
{
  auto mapper = vtkSmartPointer<Mapper>::New();
  mapper->SetEngine(engine);
  return mapper;
}

// Transparent up to 30 % of the range, whether cells are dropped for it or not.
void SetLowOpacity(BenchmarkScene& scene, vtkUnstructuredGrid* grid, double low)
{
  double range[2];
  grid->GetScalarRange(range);
  auto at = [&](double share) { return range[0] + share * (range[1] - range[0]); };
  vtkPiecewiseFunction* opacity = scene.Volume->GetProperty()->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(at(0.0), low);
  opacity->AddPoint(at(0.3), low);
  opacity->AddPoint(at(0.45), 0.5);
  opacity->AddPoint(at(1.0), 1.0);
}

// VTK's window shows colours alone: the oracle's own alpha keeps alpha out of the comparison.
vtkSmartPointer<vtkImageData> CaptureWindow(BenchmarkScene& scene, vtkImageData* oracle)
{
  auto image = scene.ReadWindow();
  for (int i = 0; i < ErrorSize * ErrorSize; ++i)
  {
    const int x = i % ErrorSize, y = i / ErrorSize;
    image->SetScalarComponentFromDouble(x, y, 0, 3, oracle->GetScalarComponentAsDouble(x, y, 0, 3));
  }
  return image;
}

double Statistic(vtkUnstructuredGridVolumeMapper* mapper, const char* column)
{
  auto* ours = vtkConvexCellMapper::SafeDownCast(mapper);
  return ours ? ours->GetLastStatistics()->GetValueByName(0, column).ToDouble() : 0.0;
}
}

//------------------------------------------------------------------------------
HexahedraBenchmark::HexahedraBenchmark(const std::string& name, vtkUnstructuredGrid* hexahedra)
  : Name(name)
  , Hexahedra(hexahedra)
  , Tetrahedra(CutToTetrahedra(hexahedra))
{
  vtkNew<vtkConvexCells> convex;
  convex->SetInputData(hexahedra);
  convex->Update();
  this->Convex = convex->GetOutput();
}

//------------------------------------------------------------------------------
void HexahedraBenchmark::AddRow(
  const std::string& name, vtkUnstructuredGridVolumeMapper* mapper, double low)
{
  Row row;
  row.Name = name;
  row.Mapper = mapper;
  row.IsCut =
    mapper->IsA("vtkPreIntegratedTetrahedraMapper") || mapper->IsA("vtkProjectedTetrahedraMapper");
  row.Low = low;
  this->Rows.push_back(std::move(row));
}

//------------------------------------------------------------------------------
void HexahedraBenchmark::AddRows()
{
  using OurMaximum = vtkMaximumProjectionMapper;
  using OurComposite = vtkPreIntegratedTetrahedraMapper;
  this->AddRow(OnePass, MakePolyhedra(1, false));
  this->AddRow("one pass, mean emission", MakePolyhedra(1, true));
  this->AddRow(ThreePasses, MakePolyhedra(3, false));
  this->AddRow(Maximum, MakeMapper<OurMaximum>(Raster));
  this->AddRow(OurTetrahedra, MakeMapper<OurComposite>(Raster));
  this->AddRow(std::string(OnePass) + OnTiles, MakePolyhedra(1, false, Tiles));
  this->AddRow(std::string(Maximum) + OnTiles, MakeMapper<OurMaximum>(Tiles));
  this->AddRow(std::string(OurTetrahedra) + OnTiles, MakeMapper<OurComposite>(Tiles));
  this->AddRow(TheirTetrahedra, vtkSmartPointer<vtkProjectedTetrahedraMapper>::New());
  auto theirMaximum = vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
  theirMaximum->SetBlendModeToMaximumIntensity();
  this->AddRow("VTK, asked for the maximum", theirMaximum);
  for (const double low : { 0.0, 1e-12 })
  {
    const std::string suffix = low == 0.0 ? ", dropping" : ", keeping all";
    this->AddRow(OnePass + suffix, MakePolyhedra(1, false), low);
    this->AddRow(ThreePasses + suffix, MakePolyhedra(3, false), low);
    this->AddRow(Maximum + suffix, MakeMapper<OurMaximum>(Raster), low);
    this->AddRow(OnePass + suffix + OnTiles, MakePolyhedra(1, false, Tiles), low);
    this->AddRow(Maximum + suffix + OnTiles, MakeMapper<OurMaximum>(Tiles), low);
  }
}

//------------------------------------------------------------------------------
std::unique_ptr<BenchmarkScene> HexahedraBenchmark::MakeScene(const Row& row, int size)
{
  vtkUnstructuredGrid* grid = row.IsCut ? this->Tetrahedra : this->Hexahedra;
  auto scene = std::make_unique<BenchmarkScene>(row.Mapper, grid, size);
  if (row.Low >= 0.0)
  {
    SetLowOpacity(*scene, grid, row.Low);
  }
  return scene;
}

//------------------------------------------------------------------------------
void HexahedraBenchmark::MeasureSpeed(int frames)
{
  FramesInTurns turns(frames);
  for (Row& row : this->Rows)
  {
    row.Scene = this->MakeScene(row, ImageSize);
    row.First = row.Scene->TimeFrame(0);
    row.Prepare = Statistic(row.Mapper, "SecondsPrepare");
    turns.Add([&row](int frame) { return row.Scene->TimeFrame(frame); }, row.Seconds);
  }
  turns.Draw();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellProjectionOracle> HexahedraBenchmark::GetOracle(
  const Row& row, BenchmarkScene& scene)
{
  // An opacity of 1e-12 is none.
  const std::string kind = std::to_string(row.Mapper->GetBlendMode()) +
                           (row.IsCut ? " cut" : " whole") + (row.Low >= 0.0 ? " low" : "");
  if (kind != this->OracleKind)
  {
    this->OracleKind = kind;
    this->Oracle = vtkSmartPointer<vtkCellProjectionOracle>::New();
    this->Oracle->SetInputData(row.IsCut ? this->Tetrahedra : this->Convex);
    this->Oracle->SetVolume(scene.Volume);
    this->Oracle->SetCamera(scene.Renderer->GetActiveCamera());
    this->Oracle->SetSize(ErrorSize, ErrorSize);
    this->Oracle->SetBlendMode(row.Mapper->GetBlendMode());
    this->Oracle->Update();
  }
  return this->Oracle;
}

//------------------------------------------------------------------------------
void HexahedraBenchmark::MeasureError(Row& row)
{
  auto* ours = vtkConvexCellMapper::SafeDownCast(row.Mapper);
  if (ours)
  {
    ours->CaptureImageOn();
  }
  const std::unique_ptr<BenchmarkScene> scene = this->MakeScene(row, ErrorSize);
  // Of the first frame of VTK's projected tetrahedra a part is missing.
  scene->TimeFrame(0);
  scene->TimeFrame(0);
  const vtkSmartPointer<vtkCellProjectionOracle> oracle = this->GetOracle(row, *scene);
  oracle->Compare(
    ours ? ours->GetCapturedImage() : CaptureWindow(*scene, oracle->GetImage()).GetPointer());
  row.RootMeanSquare = oracle->GetRootMeanSquareError();
  row.Percentile = oracle->GetPercentileError();
  row.Maximum = oracle->GetMaximumError();
}

//------------------------------------------------------------------------------
double HexahedraBenchmark::SecondsOf(const std::string& name) const
{
  const auto row = std::find_if(
    this->Rows.begin(), this->Rows.end(), [&](const Row& r) { return r.Name == name; });
  return row == this->Rows.end() ? 0.0 : Median(row->Seconds);
}

//------------------------------------------------------------------------------
void HexahedraBenchmark::Print()
{
  const double peer = this->SecondsOf(TheirTetrahedra);
  std::printf("%-32s %9s %9s %9s %8s %7s %8s %8s %9s %9s %9s\n", "mapper", "median ms", "first ms",
    "prepare", "Mhexa/s", "ratio", "drawn", "dropped", "RMSE", "99.9 %", "maximum");
  for (const Row& row : this->Rows)
  {
    const double median = Median(row.Seconds);
    std::printf("%-32s %9.1f %9.1f %9.1f %8.2f %7.2f %8.0f %8.0f %9.2e %9.2e %9.2e\n",
      row.Name.c_str(), 1e3 * median, 1e3 * row.First, 1e3 * row.Prepare,
      1e-6 * this->Hexahedra->GetNumberOfCells() / median, peer / median,
      Statistic(row.Mapper, "CellsDrawn"), Statistic(row.Mapper, "CellsSkippedTransparent"),
      row.RootMeanSquare, row.Percentile, row.Maximum);
  }
  const double one = this->SecondsOf(OnePass), three = this->SecondsOf(ThreePasses);
  std::printf("maximum %.2f x three passes (paper: 3.03); one pass %.2f x three passes; of our "
              "tetrahedra: one %.2f x, three %.2f x (paper: 2.65), maximum %.2f x\n",
    three / this->SecondsOf(Maximum), three / one, this->SecondsOf(OurTetrahedra) / one,
    this->SecondsOf(OurTetrahedra) / three,
    this->SecondsOf(OurTetrahedra) / this->SecondsOf(Maximum));
  const double cut = this->SecondsOf(std::string(OurTetrahedra) + OnTiles);
  for (const char* name : { OnePass, Maximum })
  {
    const double tiles = this->SecondsOf(std::string(name) + OnTiles);
    std::printf("%s, Tiles: %.1f x faster than Raster, %.2f x than tetrahedra by Tiles\n", name,
      this->SecondsOf(name) / tiles, cut / tiles);
  }
}

//------------------------------------------------------------------------------
void HexahedraBenchmark::Run(int frames)
{
  const int count = std::max(frames, 9);
  std::printf("%s, %lld hexahedra (%lld tetrahedra), %d x %d pixels, %d frames, a new eye each; "
              "errors at %d x %d, each in its own blend mode\n",
    this->Name.c_str(), static_cast<long long>(this->Hexahedra->GetNumberOfCells()),
    static_cast<long long>(this->Tetrahedra->GetNumberOfCells()), ImageSize, ImageSize, count,
    ErrorSize, ErrorSize);
  this->AddRows();
  this->MeasureSpeed(count);
  // Rows of one kind share the oracle's picture.
  std::vector<Row*> rows;
  for (Row& row : this->Rows)
  {
    rows.push_back(&row);
  }
  std::stable_sort(rows.begin(), rows.end(),
    [](const Row* a, const Row* b)
    {
      return std::make_pair(a->Low >= 0.0, a->Mapper->GetBlendMode()) <
             std::make_pair(b->Low >= 0.0, b->Mapper->GetBlendMode());
    });
  for (Row* row : rows)
  {
    this->MeasureError(*row);
  }
  this->Print();
}
