// Repeated and coincident points, flat cells and slivers, huge and tiny coordinates.
#include "CellZoo.h"
#include "ConvexCellsTesting.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <algorithm>

namespace
{
using namespace ConvexCellsTesting;

const std::vector<Point> Cube = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
const int Edges[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 }, { 6, 7 },
  { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };

vtkSmartPointer<vtkUnstructuredGrid> OneHexahedron(
  const std::vector<Point>& points, int precision = VTK_DOUBLE)
{
  auto grid = MakeGrid(points, precision);
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
  return grid;
}

// One edge of a cube collapsed, by a repeated id or by a coincident point: in either mode its
// tetrahedra, none missing at its surface of 10 triangles. Two faces go warped, so that each diagonal
// gives a volume of its own. In four of them corner 0 looks along a half of such a face, and another
// corner or a point within has to do: then no flat piece is dropped.
void TestCollapsedEdge(int from, int to, bool coincident, bool tetrahedraOnly)
{
  std::vector<Point> points = Cube;
  points[from] = points[to];
  std::vector<vtkIdType> ids = { 0, 1, 2, 3, 4, 5, 6, 7 };
  if (!coincident)
  {
    points[from] = { 9, 9, 9 };
    ids[from] = to;
  }
  auto grid = MakeGrid(points);
  AddCell(grid, VTK_HEXAHEDRON, ids);
  auto filter = Run(grid, tetrahedraOnly);
  const double volume = TotalVolume(filter->GetOutput());
  const std::array<int, 2> collapsed = { from, to };
  const std::vector<std::array<int, 2>> along = { { 2, 1 }, { 7, 4 }, { 5, 1 }, { 7, 3 } };
  const int other = static_cast<int>(std::count(along.begin(), along.end(), collapsed));
  CHECK(Near(volume, 2.0 / 3.0) || Near(volume, 5.0 / 6.0) || Near(volume, 1.0 / 2.0));
  const CellZoo::FaceUses uses = CellZoo::CountFaceUses(filter->GetOutput());
  CHECK_EQUAL(uses.Once, 10);
  CHECK_EQUAL(uses.More, 0);
  CHECK_EQUAL(filter->GetNumberOfDegenerateCells(), 1 - other);
  CHECK(filter->GetNumberOfDroppedTetrahedra() >= 1 - other);
  CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0);
  CHECK_EQUAL(filter->GetNumberOfInvertedCells(), 0);
  CHECK_EQUAL(filter->GetNumberOfMergedPoints(), coincident ? 1 : 0);
  const vtkIdType added = filter->GetOutput()->GetNumberOfPoints() - (coincident ? 7 : 8);
  CHECK(added == 0 || (added == 1 && other == 1));
}

// A hexahedron whose top is one point is a pyramid; one whose top edges are, two by two, a wedge.
void TestCollapsedFaces()
{
  auto grid = MakeGrid(Cube);
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 4, 4, 4 });
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 5, 4 });
  AddCell(grid, VTK_WEDGE, { 0, 2, 1, 4, 4, 4 });
  AddCell(grid, VTK_PYRAMID, { 0, 1, 2, 2, 4 });
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 0, 1, 2, 3 });
  for (bool tetrahedraOnly : { false, true })
  {
    auto filter = Run(grid, tetrahedraOnly);
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 2 + 3 + 1 + 1);
    CHECK(Near(TotalVolume(filter->GetOutput()), 1. / 3 + 1. / 2 + 1. / 6 + 1. / 6));
    CHECK_EQUAL(filter->GetNumberOfZeroVolumeCells(), 1);
    CHECK_EQUAL(filter->GetNumberOfDegenerateCells(), 5);
  }
}

// The smallest id gives the merged point its data, and the order of the points stays.
void TestMergedData()
{
  std::vector<Point> points = { { 5, 5, 5 }, { 0, 0, 0 }, { 1, 0, 0 }, { -0.0, 0, -0.0 },
    { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 0, 0 } };
  auto grid = MakeGrid(points);
  AddCell(grid, VTK_TETRA, { 3, 6, 4, 5 });
  AddCell(grid, VTK_TETRA, { 7, 2, 4, 5 });
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (int i = 0; i < 8; ++i)
  {
    values->InsertNextValue(i);
  }
  grid->GetPointData()->AddArray(values);
  auto filter = Run(grid, false);
  auto* output = filter->GetOutput();
  CHECK_EQUAL(filter->GetNumberOfMergedPoints(), 3);
  CHECK_EQUAL(output->GetNumberOfPoints(), 5);
  const double kept[5] = { 0, 1, 2, 4, 5 };
  auto* carried = output->GetPointData()->GetArray("values");
  for (vtkIdType id = 0; id < 5 && CHECK(carried); ++id)
  {
    CHECK_EQUAL(carried->GetTuple1(id), kept[id]);
    CHECK(PointOf(output, id) == points[static_cast<std::size_t>(kept[id])]);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    output->GetCellPoints(cell, ids);
    CHECK_EQUAL(ids->GetId(0), 1);
    CHECK_EQUAL(ids->GetId(1), 2);
  }
}

// The box keeps its six tetrahedra and its volume after it is squeezed, turned, scaled and moved.
void TestBox(double squeeze, double scale, double shift, int precision, double tolerance)
{
  std::vector<Point> points = Cube;
  for (Point& p : points)
  {
    const double low = p[2] * squeeze;
    const bool turned = precision == VTK_DOUBLE && shift == 0.0;
    const double c = turned ? .8 : 1, s = turned ? .6 : 0;
    p = { (c * p[0] - s * low) * scale + shift, p[1] * scale + shift,
      (s * p[0] + c * low) * scale + shift };
  }
  auto filter = Run(OneHexahedron(points, precision), true);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 6);
  CHECK_EQUAL(filter->GetNumberOfDroppedTetrahedra(), 0);
  CHECK_EQUAL(filter->GetNumberOfInvertedCells(), 0);
  const double volume = scale * scale * scale * squeeze;
  CHECK(
    volume < 1e-300 || volume > 1e300 || Near(TotalVolume(filter->GetOutput()), volume, tolerance));
}

void TestFlatBox(int precision)
{
  // Flat in a plane that is not exact in either precision.
  std::vector<Point> points = Cube;
  for (Point& p : points)
  {
    p = { p[0] + .1, p[1] + .1 * p[2], .1 };
  }
  for (bool tetrahedraOnly : { false, true })
  {
    auto filter = Run(OneHexahedron(points, precision), tetrahedraOnly);
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
    CHECK_EQUAL(filter->GetNumberOfZeroVolumeCells(), 1);
    CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 1);
  }
}

// A corner pushed through the cell: both signs, and still every tetrahedron is positive.
void TestFolded()
{
  std::vector<Point> points = Cube;
  points[6] = { -.5, -.5, -.5 };
  auto filter = Run(OneHexahedron(points), true);
  CHECK_EQUAL(filter->GetNumberOfFoldedCells(), 1);
  CHECK(TotalVolume(filter->GetOutput()) > 0.0);
}

// A lattice and one point far away: no spatial bucket may hold them all.
void TestOutlier()
{
  std::vector<Point> points;
  for (int i = 0; i < 200000; ++i)
  {
    points.push_back({ double(i % 50), double(i / 50 % 50), double(i / 2500 % 40) });
  }
  points.push_back({ 1e30, 1e30, 1e30 });
  auto grid = MakeGrid(points);
  AddCell(grid, VTK_TETRA, { 100001, 1, 50, 102500 });
  auto filter = Run(grid, true);
  CHECK_EQUAL(filter->GetNumberOfMergedPoints(), 100000);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 100001);
  CHECK_EQUAL(filter->GetNumberOfZeroVolumeCells(), 1);
}
}

int TestConvexCellsDegenerate(int, char*[])
{
  for (const auto& edge : Edges)
  {
    for (int options = 0; options < 4; ++options)
    {
      TestCollapsedEdge(edge[0], edge[1], options & 1, options & 2);
      TestCollapsedEdge(edge[1], edge[0], options & 1, options & 2);
    }
  }
  TestCollapsedFaces();
  TestMergedData();
  TestBox(1e-6, 1, 0, VTK_DOUBLE, 1e-9);
  TestBox(1e-12, 1, 0, VTK_DOUBLE, 1e-2);
  TestBox(1e-6, 1, 0, VTK_FLOAT, 1e-6);
  TestBox(1e-6, 1e7, 0, VTK_DOUBLE, 1e-9);
  TestBox(1e-6, 1e-7, 0, VTK_DOUBLE, 1e-9);
  TestBox(1e-6, 1e-7, 0, VTK_FLOAT, 1e-6);
  TestBox(1, 1, 1e7, VTK_FLOAT, 1e-12);
  TestBox(1e-6, 1, 1e7, VTK_DOUBLE, 1e-2);
  TestBox(1, 1e-7, 1, VTK_DOUBLE, 1e-6);
  TestBox(1, 1e-150, 0, VTK_DOUBLE, 1e-9);
  TestBox(1, 1e150, 0, VTK_DOUBLE, 1e-9);
  TestFlatBox(VTK_FLOAT);
  TestFlatBox(VTK_DOUBLE);
  TestFolded();
  TestOutlier();
  return Result();
}
