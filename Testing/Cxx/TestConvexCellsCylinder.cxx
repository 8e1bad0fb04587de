// The same cylinder in quadratic and in linear tetrahedra: their images agree where their fields do,
// and where the quadratic field is more than linear, refining Tolerance converges to it. Needs
// CELLPROJECTION_DATA.
#include "TestScene.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkConvexCells.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGridReader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace
{
constexpr int Skipped = 125;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

Grid Read(const std::string& name)
{
  const char* folder = std::getenv("CELLPROJECTION_DATA");
  const std::string file = std::string(folder ? folder : ".") + "/" + name;
  if (!std::ifstream(file))
  {
    std::cout << "skipped: CELLPROJECTION_DATA names no folder with " << name << "\n";
    return nullptr;
  }
  vtkNew<vtkUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->ReadAllScalarsOn();
  reader->Update();
  return reader->GetOutput();
}

// The array of `from`, moved to 0 .. 1 and named "scalar", at the first points of `grid`, which are
// those of `from`.
void TakeScalar(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* from, const char* name)
{
  vtkDataArray* values = from->GetPointData()->GetArray(name);
  double range[2];
  values->GetRange(range);
  vtkNew<vtkDoubleArray> scalar;
  scalar->SetName("scalar");
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    scalar->InsertNextValue((values->GetTuple1(id) - range[0]) / (range[1] - range[0]));
  }
  grid->GetPointData()->SetScalars(scalar);
}

vtkSmartPointer<vtkImageData> Draw(vtkUnstructuredGrid* grid, double tolerance)
{
  TestScene scene;
  // Along the cylinder a third of the light comes through.
  scene.Property->SetScalarOpacityUnitDistance(0.02);
  scene.Mapper->SetTolerance(tolerance);
  scene.Mapper->SetInputData(grid);
  scene.LookFrom(0.2, 0.15, 0.1);
  scene.Renderer->ResetCamera();
  scene.Render();
  return scene.CopyCaptured();
}

double RootMeanSquare(vtkImageData* a, vtkImageData* b)
{
  double sum = 0.0, count = 0.0;
  for (vtkIdType pixel = 0; pixel < a->GetNumberOfPoints(); ++pixel)
  {
    const double* p = a->GetPointData()->GetScalars()->GetTuple(pixel);
    const std::array<double, 4> first = { p[0], p[1], p[2], p[3] };
    const double* q = b->GetPointData()->GetScalars()->GetTuple(pixel);
    const bool covered = first[3] > 0.0 || q[3] > 0.0;
    for (int i = 0; i < 4 && covered; ++i)
    {
      sum += (first[i] - q[i]) * (first[i] - q[i]);
      count += 1.0;
    }
  }
  return count > 0.0 ? std::sqrt(sum / count) : 1.0;
}

// How far what goes out is from the quadratic field, in the middles of its cells and of their edges,
// by VTK's own shape functions.
double FieldError(vtkUnstructuredGrid* grid, double tolerance, vtkIdType& cells)
{
  vtkNew<vtkConvexCells> filter;
  filter->SetInputData(grid);
  filter->TetrahedraOnlyOn();
  filter->SetTolerance(tolerance);
  filter->Update();
  vtkUnstructuredGrid* output = filter->GetOutput();
  auto* source = vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("SourceCell"));
  vtkDataArray* exact = grid->GetPointData()->GetScalars();
  vtkDataArray* made = output->GetPointData()->GetScalars();
  double largest = 0.0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    vtkCell* piece = output->GetCell(cell);
    // Of pairs of corners, and of all.
    for (const auto& ends : { std::array<int, 4>{ 0, 0, 1, 1 }, { 0, 0, 2, 2 }, { 0, 0, 3, 3 },
           { 1, 1, 2, 2 }, { 1, 1, 3, 3 }, { 2, 2, 3, 3 }, { 0, 1, 2, 3 } })
    {
      double middle[3] = { 0, 0, 0 }, linear = 0.0, field = 0.0;
      for (const int corner : ends)
      {
        double x[3];
        piece->GetPoints()->GetPoint(corner, x);
        std::transform(x, x + 3, middle, middle, [](double a, double m) { return m + a / 4.0; });
        linear += made->GetTuple1(piece->GetPointId(corner)) / 4.0;
      }
      vtkCell* quadratic = grid->GetCell(source->GetValue(cell));
      double closest[3], p[3], distance, weights[10];
      int part = 0;
      quadratic->EvaluatePosition(middle, closest, part, p, distance, weights);
      for (int i = 0; i < 10; ++i)
      {
        field += weights[i] * exact->GetTuple1(quadratic->GetPointId(i));
      }
      largest = std::max(largest, std::abs(field - linear));
    }
  }
  cells = output->GetNumberOfCells();
  return largest;
}

// The pressure is linear in each cell of both.
void CheckAgreement(TestChecks& checks, vtkUnstructuredGrid* linear, vtkUnstructuredGrid* quadratic)
{
  TakeScalar(linear, quadratic, "pressure");
  TakeScalar(quadratic, quadratic, "pressure");
  auto twin = Draw(linear, 1e-3);
  for (const double tolerance : { 1e-2, 1e-3, 1e-5 })
  {
    const double difference = TestScene::Difference(Draw(quadratic, tolerance), twin);
    std::cout << "pressure, tolerance " << tolerance << ": images differ by " << difference << "\n";
    CHECK(difference >= 0.0);
    CHECK_AT_MOST(difference, 1e-2);
  }
}

// The largest difference at the points of `linear`, which come first in the other.
double CornerDifference(vtkUnstructuredGrid* linear, vtkUnstructuredGrid* quadratic)
{
  vtkDataArray* a = linear->GetPointData()->GetScalars();
  vtkDataArray* b = quadratic->GetPointData()->GetScalars();
  double largest = 0.0;
  for (vtkIdType id = 0; id < linear->GetNumberOfPoints(); ++id)
  {
    double x[3], y[3];
    linear->GetPoint(id, x);
    quadratic->GetPoint(id, y);
    largest = std::max({ largest, std::abs(a->GetTuple1(id) - b->GetTuple1(id)),
      std::sqrt(vtkMath::Distance2BetweenPoints(x, y)) });
  }
  return largest;
}

// The velocity is linear between the corners in one and quadratic in the other: the same at the
// corners, and in the middle of edges off by up to 0.73 of its range. So the images of the two files
// differ by what the linear one lacks, 4.9e-2, and not by how the quadratic one is drawn.
void CheckConvergence(
  TestChecks& checks, vtkUnstructuredGrid* linear, vtkUnstructuredGrid* quadratic)
{
  TakeScalar(linear, linear, "vel_norm");
  TakeScalar(quadratic, quadratic, "velocity_norm");
  auto twin = Draw(linear, 1.0);
  const double coarse = TestScene::Difference(Draw(quadratic, 1.0), twin);
  CHECK(coarse >= 0.0);
  CHECK_AT_MOST(coarse, 1e-5);
  vtkIdType cells = 0;
  double before = FieldError(quadratic, 1.0, cells);
  CHECK(CornerDifference(linear, quadratic) == 0.0);
  CHECK(before > 0.7);
  auto finest = Draw(quadratic, 5e-3);
  double imageBefore = RootMeanSquare(twin, finest);
  std::cout << "velocity: the fields differ by up to " << before << " of their range, the images by "
            << imageBefore << "\n";
  for (const double tolerance : { 1e-1, 5e-2, 2e-2 })
  {
    const double error = FieldError(quadratic, tolerance, cells);
    const double imageError = RootMeanSquare(Draw(quadratic, tolerance), finest);
    std::cout << "velocity, tolerance " << tolerance << ": " << cells << " cells, field within "
              << error << ", image within " << imageError << "\n";
    // VTK finds the place in its cell to about 1e-5.
    CHECK_AT_MOST(error, 1.001 * tolerance);
    CHECK(error < 0.8 * before && imageError < 0.8 * imageBefore);
    before = error;
    imageBefore = imageError;
  }
  CHECK_AT_MOST(imageBefore, 5e-3);
}
}

int TestConvexCellsCylinder(int, char*[])
{
  TestChecks checks;
  Grid linear = Read("CylinderLinear.vtk"), quadratic = Read("CylinderQuadratic.vtk");
  if (!linear || !quadratic)
  {
    return Skipped;
  }
  CheckAgreement(checks, linear, quadratic);
  CheckConvergence(checks, linear, quadratic);
  return checks.Result();
}
