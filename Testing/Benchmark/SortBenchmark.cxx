#include "SortBenchmark.h"

#include "BenchmarkScene.h"
#include "CellComplex.h"
#include "CellComplexReader.h"
#include "Convexification.h"
#include "OrderProof.h"
#include "ViewEye.h"
#include "vtkBSPXMPVOVisibilitySort.h"

#include "vtkCamera.h"
#include "vtkCellCenterDepthSort.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkMPVOVisibilitySort.h"
#include "vtkMatrix4x4.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkPoints.h"
#include "vtkPowerVisibilitySort.h"
#include "vtkUnstructuredGrid.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace
{
// What VTK's own mapper asks for at a time.
constexpr int BatchSize = 1000;

struct Row
{
  vtkSmartPointer<vtkVisibilitySort> Sort;
  vtkIdType Sum = 0; // of the ids, so that reading them is not left out
  double First = 0.0;
  std::vector<double> Seconds;
};

double SecondsOf(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void MoveEye(vtkCamera* camera, vtkUnstructuredGrid* grid, int frame)
{
  double center[3];
  grid->GetCenter(center);
  const double angle = 0.7 + 0.01 * frame, distance = 1.3 * grid->GetLength();
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] + 0.8 * distance * std::cos(angle), center[1] - 0.6 * distance,
    center[2] + 0.8 * distance * std::sin(angle));
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(0.01 * distance, 10.0 * distance);
}

// The whole order is read, as a mapper does.
double TimeFrame(Row& row)
{
  return SecondsOf(
    [&row]
    {
      row.Sort->InitTraversal();
      while (vtkIdTypeArray* batch = row.Sort->GetNextCells())
      {
        const vtkIdType* ids = batch->GetPointer(0);
        row.Sum = std::accumulate(ids, ids + batch->GetNumberOfValues(), row.Sum);
      }
    });
}

std::vector<vtkIdType> OrderOf(vtkVisibilitySort* sort)
{
  std::vector<vtkIdType> order;
  sort->InitTraversal();
  while (vtkIdTypeArray* batch = sort->GetNextCells())
  {
    const vtkIdType* ids = batch->GetPointer(0);
    order.insert(order.end(), ids, ids + batch->GetNumberOfValues());
  }
  return order;
}

void TimeFrames(std::vector<Row>& rows, vtkUnstructuredGrid* grid, vtkCamera* camera, int frames)
{
  MoveEye(camera, grid, 0);
  for (Row& row : rows)
  {
    row.Sort->SetInput(grid);
    row.Sort->SetCamera(camera);
    row.Sort->SetMaxCellsReturned(BatchSize);
    row.First = TimeFrame(row);
  }
  for (int frame = 1; frame <= frames; ++frame)
  {
    MoveEye(camera, grid, frame);
    for (Row& row : rows)
    {
      row.Seconds.push_back(TimeFrame(row));
    }
  }
}

// Built apart from the sorts, to say what they spend on it.
CellComplex PrintPreparation(const std::string& name, vtkUnstructuredGrid* grid, int frames)
{
  CellComplex complex;
  ConvexificationResult result;
  const double reading = SecondsOf([&] { CellComplexReader::Read(grid, complex); });
  const double filling =
    SecondsOf([&] { result = Convexification::Run(complex, ConvexificationSettings()); });
  std::printf("\nSorts on %s, %lld cells, %zu shared triangles, %d frames, a new eye each\n"
              "adjacency %.2f s, convexification %.2f s (%d imaginary cells)\n",
    name.c_str(), static_cast<long long>(grid->GetNumberOfCells()), complex.Contacts.size(), frames,
    reading, filling, result.Cells.GetNumberOfCells());
  std::printf("%-32s %9s %9s %9s %8s %7s %8s %7s\n", "sort", "prepare s", "first ms", "median ms",
    "Mcells/s", "ratio", "% wrong", "cycles");
  return complex;
}

std::string CyclesOf(vtkVisibilitySort* sort)
{
  auto* proven = vtkProvenVisibilitySort::SafeDownCast(sort);
  return proven ? std::to_string(proven->GetNumberOfCycles()) : "-";
}

vtkSmartPointer<vtkPoints> MakeLatticePoints(int cells)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(1);
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  const auto isInside = [cells](int i) { return i > 0 && i < cells; };
  for (int k = 0; k <= cells; ++k)
  {
    for (int j = 0; j <= cells; ++j)
    {
      for (int i = 0; i <= cells; ++i)
      {
        double p[3] = { double(i), double(j), double(k) };
        for (int axis = 0; axis < 3 && isInside(i) && isInside(j) && isInside(k); ++axis)
        {
          random->Next();
          p[axis] += 0.4 * random->GetValue() - 0.2;
        }
        points->InsertNextPoint(p);
      }
    }
  }
  return points;
}

// The six tetrahedra about the diagonal from the cube's first corner.
void InsertCube(vtkUnstructuredGrid* grid, vtkIdType corner, vtkIdType side)
{
  const vtkIdType steps[3] = { 1, side, side * side };
  const vtkIdType last = corner + 1 + side + side * side;
  for (int first = 0; first < 3; ++first)
  {
    for (int turn = 1; turn < 3; ++turn)
    {
      const vtkIdType second = corner + steps[first];
      const vtkIdType ids[4] = { corner, second, second + steps[(first + turn) % 3], last };
      grid->InsertNextCell(VTK_TETRA, 4, ids);
    }
  }
}
}

//------------------------------------------------------------------------------
SortBenchmark::SortBenchmark()
{
  const auto makeMPVO = [](bool convexify)
  {
    auto sort = vtkSmartPointer<vtkMPVOVisibilitySort>::New();
    sort->SetConvexify(convexify);
    return sort;
  };
  this->Contenders = {
    { "vtkCellCenterDepthSort", [] { return vtkSmartPointer<vtkCellCenterDepthSort>::New(); } },
    { "vtkPowerVisibilitySort", [] { return vtkSmartPointer<vtkPowerVisibilitySort>::New(); } },
    { "vtkMPVOVisibilitySort, plain", [=] { return makeMPVO(false); } },
    { "vtkMPVOVisibilitySort", [=] { return makeMPVO(true); } },
    { "vtkBSPXMPVOVisibilitySort",
      [] { return vtkSmartPointer<vtkBSPXMPVOVisibilitySort>::New(); } },
  };
}

//------------------------------------------------------------------------------
void SortBenchmark::Run(const std::string& name, vtkUnstructuredGrid* grid, int frames)
{
  const CellComplex complex = PrintPreparation(name, grid, frames);
  std::vector<Row> rows;
  for (const Contender& contender : this->Contenders)
  {
    rows.push_back({ contender.Make(), 0, 0.0, {} });
  }
  vtkNew<vtkCamera> camera;
  TimeFrames(rows, grid, camera, frames);
  vtkNew<vtkMatrix4x4> identity;
  double eye[4];
  ViewEye::Find(camera, identity, eye);
  const double peer = Median(rows[0].Seconds);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const Row& row = rows[i];
    const double median = Median(row.Seconds);
    const vtkIdType wrong = OrderProof::CountMisordered(complex, OrderOf(row.Sort), eye);
    std::printf("%-32s %9.2f %9.1f %9.1f %8.1f %7.2f %8.3f %7s\n", this->Contenders[i].Name.c_str(),
      row.First - median, 1e3 * row.First, 1e3 * median, 1e-6 * grid->GetNumberOfCells() / median,
      peer / median, 100.0 * static_cast<double>(wrong) / complex.Contacts.size(),
      CyclesOf(row.Sort).c_str());
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> SortBenchmark::MakeLattice(int cells)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const vtkIdType side = cells + 1;
  grid->SetPoints(MakeLatticePoints(cells));
  grid->Allocate(6 * cells * cells * cells);
  for (vtkIdType k = 0; k < cells; ++k)
  {
    for (vtkIdType j = 0; j < cells; ++j)
    {
      for (vtkIdType i = 0; i < cells; ++i)
      {
        InsertCube(grid, i + side * (j + side * k), side);
      }
    }
  }
  return grid;
}
