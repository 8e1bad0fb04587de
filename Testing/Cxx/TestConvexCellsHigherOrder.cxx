// Quadratic, Lagrange and Bezier cells and convex point sets: straight ones go out as their linear
// twins, curved ones follow the tolerance, and their volumes converge.
#include "CellZoo.h"
#include "ConvexCellsTesting.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"

#include <functional>

namespace
{
using namespace ConvexCellsTesting;
using Move = std::function<Point(const Point&)>;

bool IsBezier(int type)
{
  return type == VTK_BEZIER_TETRAHEDRON || type == VTK_BEZIER_HEXAHEDRON ||
         type == VTK_BEZIER_WEDGE;
}

void MovePoints(vtkUnstructuredGrid* grid, const Move& move)
{
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    grid->GetPoints()->SetPoint(id, move(PointOf(grid, id)).data());
  }
}

vtkSmartPointer<vtkConvexCells> Follow(vtkUnstructuredGrid* grid, double tolerance)
{
  auto filter = vtkSmartPointer<vtkConvexCells>::New();
  filter->SetInputData(grid);
  filter->SetTolerance(tolerance);
  filter->Update();
  return filter;
}

// As it stands in VTK's reference cell nothing is off.
void TestStraight(int type)
{
  auto grid = CellZoo::Reference(type);
  for (const bool tetrahedraOnly : { false, true })
  {
    auto filter = Run(grid, tetrahedraOnly);
    CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0);
    const double box = type == VTK_PENTAGONAL_PRISM || type == VTK_HEXAGONAL_PRISM ? 0.0 : 1.0;
    const double volume = VolumeWithin(filter->GetOutput());
    const int cells = static_cast<int>(filter->GetOutput()->GetNumberOfCells());
    CHECK(tetrahedraOnly ? cells >= 1 : cells == 1);
    if (!CHECK(box == 0.0 || Near(volume, 1.0) || Near(volume, 0.5) || Near(volume, 1.0 / 3.0) ||
               Near(volume, 1.0 / 6.0)))
    {
      std::cerr << "  type " << type << ": volume " << volume << "\n";
    }
  }
}

// (x + xy + yy, y, z), which shape functions of degree two can follow but VTK's pyramids cannot;
// it makes the volume at y larger by a factor of 1 + y. Bezier cells have it as control points.
Point Bend(const Point& x, int type, int degree)
{
  const double n = degree;
  const bool bezier = IsBezier(type);
  const double square = bezier ? x[1] * (n * x[1] - 1.0) / (n - 1.0) : x[1] * x[1];
  const double product = bezier && type != VTK_BEZIER_HEXAHEDRON ? x[0] * x[1] * n / (n - 1.0)
                                                                 : x[0] * x[1];
  return { x[0] + product + square, x[1], x[2] };
}

// The integral of y over the reference cell.
double MomentOf(vtkUnstructuredGrid* grid)
{
  auto tetrahedra = Run(grid, true);
  vtkUnstructuredGrid* output = tetrahedra->GetOutput();
  double moment = 0.0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    moment += TetrahedronVolume(output, cell) * Middle(output->GetCell(cell)->GetPoints())[1];
  }
  return moment;
}

void TestBent(int type, int degree)
{
  auto grid = CellZoo::Reference(type, degree);
  const bool exact = type != VTK_QUADRATIC_PYRAMID && type != VTK_TRIQUADRATIC_PYRAMID;
  double volume = VolumeWithin(Run(grid, true)->GetOutput()) + MomentOf(grid);
  MovePoints(grid, [&](const Point& x) { return Bend(x, type, degree); });
  volume = exact ? volume : VolumeWithin(Follow(grid, 5e-4)->GetOutput());
  double errors[3];
  vtkIdType counts[3];
  for (int level = 0; level < 3; ++level)
  {
    auto filter = Follow(grid, std::pow(10.0, -1 - level));
    errors[level] = std::abs(VolumeWithin(filter->GetOutput()) / volume - 1.0);
    counts[level] = filter->GetOutput()->GetNumberOfCells();
    // Bent like this, VTK's quadratic pyramid folds at its apex.
    CHECK(type == VTK_QUADRATIC_PYRAMID || filter->GetNumberOfCoarseCells() == 0);
    CHECK(type == VTK_QUADRATIC_PYRAMID || filter->GetNumberOfFoldedCells() == 0);
    // Surface times diagonal is less than 30 times the volume.
    CHECK(errors[level] < 30.0 * std::pow(10.0, -1 - level));
  }
  CHECK(counts[0] < counts[1] && counts[1] < counts[2]);
  if (!CHECK(errors[2] < 2.5e-3))
  {
    std::cerr << "  type " << type << ", degree " << degree << ": errors " << errors[0] << ", "
              << errors[1] << ", " << errors[2] << ", cells " << counts[2] << "\n";
  }
}

// A straight cell with a field of degree two: halved where the field is off, and the data of the
// new points are the field's.
void TestField(int type)
{
  auto grid = CellZoo::Reference(type);
  const auto field = [](const Point& x) { return x[0] * x[1] - 2.0 * x[2] * x[2] + x[1]; };
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("scalar");
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    scalars->InsertNextValue(field(PointOf(grid, id)));
  }
  grid->GetPointData()->SetScalars(scalars);
  auto filter = Follow(grid, 1e-2);
  vtkUnstructuredGrid* output = filter->GetOutput();
  CHECK(output->GetNumberOfCells() > 20);
  vtkDataArray* made = output->GetPointData()->GetScalars();
  double largest = 0.0;
  for (vtkIdType id = 0; CHECK(made) && id < output->GetNumberOfPoints(); ++id)
  {
    largest = std::max(largest, std::abs(made->GetTuple1(id) - field(PointOf(output, id))));
  }
  if (!CHECK(largest < 1e-12))
  {
    std::cerr << "  type " << type << ": field off by " << largest << "\n";
  }
  // Data that are not followed cut nothing.
  grid->GetPointData()->SetActiveScalars(nullptr);
  auto other = vtkSmartPointer<vtkConvexCells>::New();
  vtkNew<vtkDoubleArray> flat;
  flat->SetName("flat");
  flat->SetNumberOfValues(grid->GetNumberOfPoints());
  flat->FillValue(1.0);
  grid->GetPointData()->AddArray(flat);
  other->SetInputData(grid);
  other->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "flat");
  other->Update();
  CHECK_EQUAL(other->GetOutput()->GetNumberOfCells(), 1);
}

// Curved cells that cannot be evaluated.
void TestBad()
{
  const std::vector<int> types = { VTK_QUADRATIC_TETRA, VTK_LAGRANGE_HEXAHEDRON,
    VTK_BEZIER_WEDGE, VTK_LAGRANGE_TETRAHEDRON, VTK_TRIQUADRATIC_PYRAMID };
  for (const int type : types)
  {
    auto good = CellZoo::Reference(type);
    vtkNew<vtkIdList> ids;
    good->GetCellPoints(0, ids);
    std::vector<vtkIdType> list(ids->begin(), ids->end());
    std::vector<vtkIdType> shorter(list.begin(), list.end() - 1), wrong = list;
    wrong.back() = 1000000;
    AddCell(good, type, shorter);
    AddCell(good, type, wrong);
    AddCell(good, type, {});
    auto filter = Run(good, true);
    CHECK_EQUAL(filter->GetNumberOfInvalidCells(), 3);
    CHECK_EQUAL(filter->GetLeftOutSummary(),
      std::string("cells left out: 3 with a wrong list of points"));
    good->GetPoints()->SetPoint(list.back(), std::nan(""), 0, 0);
    CHECK_EQUAL(Run(good, true)->GetNumberOfNonFiniteCells(), 1);
  }
}

// The corners of a hexahedron, with points on an edge, in a face and within.
void TestConvexPointSet()
{
  auto grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 }, { .5, 0, 0 }, { .5, .5, 1 }, { .5, .5, .5 } });
  AddCell(grid, VTK_CONVEX_POINT_SET, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 });
  AddCell(grid, VTK_CONVEX_POINT_SET, { 0, 1, 2, 3 });
  AddCell(grid, VTK_CONVEX_POINT_SET, { 0, 1, 2, 5 });
  AddCell(grid, VTK_CONVEX_POINT_SET, { 0, 1, 2 });
  AddCell(grid, VTK_CONVEX_POINT_SET, {});
  AddCell(grid, VTK_CONVEX_POINT_SET, { 0, 1, 2, 99 });
  for (const bool tetrahedraOnly : { false, true })
  {
    auto filter = Run(grid, tetrahedraOnly);
    CHECK_EQUAL(filter->GetNumberOfZeroVolumeCells(), 3);
    CHECK_EQUAL(filter->GetNumberOfInvalidCells(), 1);
    CHECK(Near(VolumeWithin(filter->GetOutput()), 1.0 + 1.0 / 6.0));
  }
  auto filter = Run(grid, false);
  vtkCell* hull = filter->GetOutput()->GetCell(0);
  CHECK_EQUAL(hull->GetNumberOfFaces(), 6);
  CHECK_EQUAL(hull->GetNumberOfPoints(), 9);
}
}

int TestConvexCellsHigherOrder(int, char*[])
{
  for (const int type : CellZoo::AllTypes())
  {
    TestStraight(type);
  }
  for (const int type : { VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE,
         VTK_QUADRATIC_PYRAMID, VTK_TRIQUADRATIC_HEXAHEDRON, VTK_TRIQUADRATIC_PYRAMID,
         VTK_QUADRATIC_LINEAR_WEDGE, VTK_BIQUADRATIC_QUADRATIC_WEDGE,
         VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON })
  {
    TestBent(type, 2);
  }
  for (const int type : { VTK_LAGRANGE_TETRAHEDRON, VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE,
         VTK_BEZIER_TETRAHEDRON, VTK_BEZIER_HEXAHEDRON, VTK_BEZIER_WEDGE })
  {
    TestBent(type, 2);
    TestBent(type, 3);
  }
  for (const int type : { VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_LAGRANGE_TETRAHEDRON,
         VTK_LAGRANGE_HEXAHEDRON, VTK_TRIQUADRATIC_HEXAHEDRON })
  {
    TestField(type);
  }
  TestBad();
  TestConvexPointSet();
  return Result();
}
