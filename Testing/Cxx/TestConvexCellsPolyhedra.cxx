// Polyhedra that are drawn: whole or as tetrahedra, however their faces are wound, with points
// merged and renumbered like all others.
#include "CellZoo.h"
#include "ConvexCellsTesting.h"
#include "VTKVersions.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"

#include <algorithm>

namespace
{
using namespace ConvexCellsTesting;

const std::vector<vtkIdType> Corners = { 0, 1, 2, 3, 4, 5, 6, 7 };

std::vector<Point> Box(double x)
{
  return { { x, 0, 0 }, { x + 1, 0, 0 }, { x + 1, 1, 0 }, { x, 1, 0 }, { x, 0, 1 }, { x + 1, 0, 1 },
    { x + 1, 1, 1 }, { x, 1, 1 } };
}

vtkIdType SourceOf(vtkUnstructuredGrid* output, vtkIdType cell)
{
  return vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("SourceCell"))
    ->GetValue(cell);
}

void TestWindings()
{
  for (int mask = 0; mask < 64; ++mask)
  {
    Faces faces = BoxFaces(Corners);
    for (int face = 0; face < 6; ++face)
    {
      if (mask >> face & 1)
      {
        std::reverse(faces[face].begin(), faces[face].end());
      }
    }
    auto grid = MakeGrid(Box(0));
    AddPolyhedron(grid, faces);
    auto filter = Run(grid, false);
    vtkUnstructuredGrid* output = filter->GetOutput();
    CHECK_EQUAL(output->GetCellType(0), VTK_POLYHEDRON);
    CHECK_EQUAL(output->GetCell(0)->GetNumberOfFaces(), 6);
    CHECK(FacesOutward(output->GetCell(0)));
    CHECK(Near(VolumeWithin(output), 1.0));
    CHECK_EQUAL(filter->GetNumberOfInvertedCells(), mask == 0 ? 0 : 1);
    CHECK(output->GetPoints() == grid->GetPoints());
    CHECK(Near(TotalVolume(Run(grid, true)->GetOutput()), 1.0));
  }
}

// Two boxes with points of their own, after two points that nothing uses: eight become four.
void TestMergedPoints()
{
  std::vector<Point> points = { { 5, 5, 5 }, { 5, 5, 5 } };
  for (const Point& p : Box(0))
  {
    points.push_back(p);
  }
  for (const Point& p : Box(1))
  {
    points.push_back(p);
  }
  auto grid = MakeGrid(points, VTK_FLOAT);
  AddPolyhedron(grid, BoxFaces({ 2, 3, 4, 5, 6, 7, 8, 9 }));
  AddPolyhedron(grid, BoxFaces({ 10, 11, 12, 13, 14, 15, 16, 17 }));
  auto filter = Run(grid, false);
  vtkUnstructuredGrid* output = filter->GetOutput();
  CHECK_EQUAL(filter->GetNumberOfMergedPoints(), 5);
  CHECK_EQUAL(output->GetNumberOfPoints(), 13);
  CHECK_EQUAL(CountType(output, VTK_POLYHEDRON), 2);
  CHECK(Near(VolumeWithin(output), 2.0));
  vtkNew<vtkIdList> first;
  vtkNew<vtkIdList> second;
  output->GetCellPoints(0, first);
  output->GetCellPoints(1, second);
  first->IntersectWith(second);
  CHECK_EQUAL(first->GetNumberOfIds(), 4);
}

// A point that a face repeats in a row; a top that is one point, by its id and by coordinates.
void TestRepeatedPoints()
{
  std::vector<Point> points = Box(0);
  Faces faces = BoxFaces(Corners);
  faces[4] = { 0, 0, 3, 2, 2, 1, 0 };
  auto grid = MakeGrid(points);
  AddPolyhedron(grid, faces);
  auto filter = Run(grid, false);
  CHECK_EQUAL(CountType(filter->GetOutput(), VTK_POLYHEDRON), 1);
  CHECK(Near(VolumeWithin(filter->GetOutput()), 1.0));

  points[5] = points[6] = points[7] = points[4];
  auto pyramid = MakeGrid(points);
  AddPolyhedron(pyramid, BoxFaces(Corners));
  filter = Run(pyramid, false);
  CHECK_EQUAL(CountType(filter->GetOutput(), VTK_POLYHEDRON), 1);
  CHECK_EQUAL(filter->GetOutput()->GetCell(0)->GetNumberOfFaces(), 5);
  CHECK(Near(VolumeWithin(filter->GetOutput()), 1.0 / 3.0));
  CHECK(Near(TotalVolume(Run(pyramid, true)->GetOutput()), 1.0 / 3.0));
}

// An L of unit height: seen whole from the corners of the square in its bend, if each L-shaped face
// is seen whole from its smallest id, too.
void TestConcave(const std::vector<vtkIdType>& names, bool seen)
{
  const double outline[6][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
  std::vector<Point> points(12);
  Faces faces(2);
  for (int i = 0; i < 6; ++i)
  {
    points[names[i]] = { outline[i][0], outline[i][1], 0 };
    points[names[i] + 6] = { outline[i][0], outline[i][1], 1 };
    faces[0].insert(faces[0].begin(), names[i]);
    faces[1].push_back(names[i] + 6);
    const vtkIdType a = names[i], b = names[(i + 1) % 6];
    faces.push_back({ a, b, b + 6, a + 6 });
  }
  auto grid = MakeGrid(points);
  AddPolyhedron(grid, faces);
  for (const bool tetrahedraOnly : { false, true })
  {
    auto filter = Run(grid, tetrahedraOnly);
    CHECK_EQUAL(filter->GetNumberOfNonConvexCells(), seen && !tetrahedraOnly ? 1 : 0);
    CHECK_EQUAL(filter->GetNumberOfConcaveCells(), seen ? 0 : 1);
    CHECK_EQUAL(filter->GetNumberOfSkippedCells(), seen ? 0 : 1);
    CHECK(Near(TotalVolume(filter->GetOutput()), seen ? 3.0 : 0.0));
    CHECK(seen || filter->GetLeftOutSummary() ==
                    "cells left out: 1 vtkPolyhedron (concave: no point sees all of it)");
  }
}

// A hexagonal prism whose top is not planar.
void TestWarped()
{
  std::vector<Point> points;
  Faces faces(2);
  for (int i = 0; i < 12; ++i)
  {
    const double angle = 3.14159265358979323846 / 3.0 * i;
    points.push_back({ std::cos(angle), std::sin(angle), i < 6 ? 0.0 : 1.0 + 0.02 * (i % 2) });
  }
  for (vtkIdType i = 0; i < 6; ++i)
  {
    faces[0].insert(faces[0].begin(), i);
    faces[1].push_back(i + 6);
    faces.push_back({ i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6 });
  }
  auto grid = MakeGrid(points);
  AddPolyhedron(grid, faces);
  auto filter = Run(grid, false);
  CHECK_EQUAL(filter->GetNumberOfNonConvexCells(), 1);
  CHECK(Near(TotalVolume(filter->GetOutput()), VolumeWithin(grid)));
  CHECK(Near(TotalVolume(Run(grid, true)->GetOutput()), VolumeWithin(grid)));
}

// A box of which each side is four squares, as an octree has them, turned so that rounding bends
// the sides, to 1e-16 or 1e-7: it is cut up, and left out it is never.
void TestHangingPoints(int precision)
{
  std::vector<Point> points;
  const auto lattice = [](int i, int j, int k) { return vtkIdType(i + 3 * j + 9 * k); };
  for (int id = 0; id < 27; ++id)
  {
    const Point p = { double(id % 3), double(id / 3 % 3), double(id / 9) };
    points.push_back({ 1.3 + .48 * p[0] - .6 * p[1] + .64 * p[2],
      .36 * p[0] + .8 * p[1] + .48 * p[2] + .1, -.8 * p[0] + .6 * p[2] - .7 });
  }
  Faces faces;
  for (int square = 0; square < 24; ++square)
  {
    const int axis = square / 8, side = square / 4 % 2 * 2, u = square % 2, v = square / 2 % 2;
    std::vector<vtkIdType> face;
    for (const auto& step : { std::array<int, 2>{ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } })
    {
      int at[3];
      at[axis] = side;
      at[(axis + 1) % 3] = u + step[0];
      at[(axis + 2) % 3] = v + step[1];
      face.push_back(lattice(at[0], at[1], at[2]));
    }
    faces.push_back(face);
  }
  auto grid = MakeGrid(points, precision);
  AddPolyhedron(grid, faces);
  const double error = precision == VTK_DOUBLE ? 1e-12 : 1e-6;
  auto filter = Run(grid, false);
  CHECK_EQUAL(filter->GetNumberOfNonConvexCells(), 1);
  CHECK(Near(VolumeWithin(filter->GetOutput()), 8.0, error));
  filter = Run(grid, true);
  CHECK(Near(TotalVolume(filter->GetOutput()), 8.0, error));
  CHECK_EQUAL(filter->GetNumberOfDegenerateCells(), 0);
  const CellZoo::FaceUses uses = CellZoo::CountFaceUses(filter->GetOutput());
  CHECK_EQUAL(uses.Once, 48);
  CHECK_EQUAL(uses.More, 0);
}

// A face that is changed where it lies is noticed.
void TestChangedFaces()
{
  auto grid = MakeGrid(Box(0));
  AddPolyhedron(grid, BoxFaces(Corners));
  auto filter = Run(grid, false);
  CHECK_EQUAL(filter->GetNumberOfInvalidCells(), 0);
  for (vtkObject* faces : GetFaceArrays(grid))
  {
    auto* stream = vtkIdTypeArray::SafeDownCast(faces);
    if (stream && stream->GetNumberOfValues() > 2)
    {
      stream->SetValue(2, 6);
      stream->Modified();
    }
    auto* cells = vtkCellArray::SafeDownCast(faces);
    if (cells && cells->GetNumberOfCells() == 6)
    {
      const vtkIdType corners[4] = { 6, 4, 7, 3 };
      cells->ReplaceCellAtId(0, 4, corners);
      cells->Modified();
    }
  }
  grid->Modified();
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfInvalidCells(), 1);
}

// Types, order, SourceCell, and data of points, cells and the field.
void TestAmongOthers()
{
  auto grid = MakeGrid(Box(0));
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 4 });
  AddPolyhedron(grid, BoxFaces(Corners));
  AddPolyhedron(grid, { { 0, 1, 2 }, { 0, 1, 3 } });
  AddCell(grid, VTK_HEXAHEDRON, Corners);
  AddPolyhedron(grid, { { 0, 1, 3 }, { 0, 1, 4 }, { 1, 3, 4 }, { 0, 3, 4 } });
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (int i = 0; i < 5; ++i)
  {
    values->InsertNextValue(i);
  }
  grid->GetCellData()->AddArray(values);
  grid->GetFieldData()->AddArray(values);
  auto filter = Run(grid, false);
  vtkUnstructuredGrid* output = filter->GetOutput();
  const int types[] = { VTK_TETRA, VTK_POLYHEDRON, VTK_HEXAHEDRON, VTK_POLYHEDRON };
  const vtkIdType sources[] = { 0, 1, 3, 4 };
  CHECK_EQUAL(output->GetNumberOfCells(), 4);
  CHECK(output->GetFieldData()->GetArray("values") != nullptr);
  for (vtkIdType cell = 0; cell < 4; ++cell)
  {
    CHECK_EQUAL(output->GetCellType(cell), types[cell]);
    CHECK_EQUAL(SourceOf(output, cell), sources[cell]);
    CHECK_EQUAL(output->GetCellData()->GetArray("values")->GetTuple1(cell), sources[cell]);
  }

  // New data leave the cells alone; new faces do not.
  vtkCellArray* cells = output->GetCells();
  const vtkMTimeType time = cells->GetMTime();
  values->SetValue(0, 7.0);
  values->Modified();
  grid->Modified();
  filter->Update();
  CHECK(output->GetCells() == cells && cells->GetMTime() == time);
  CHECK_EQUAL(output->GetCellData()->GetArray("values")->GetTuple1(0), 7.0);
  CHECK(output->GetFieldData()->GetArray("values") != nullptr);
  CHECK(output->GetCell(1)->GetNumberOfFaces() == 6);
  filter->TetrahedraOnlyOn();
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 1 + 6 + 6 + 1);
  CHECK(Near(TotalVolume(filter->GetOutput()), 2.0 + 2.0 / 6.0));
}
}

int TestConvexCellsPolyhedra(int, char*[])
{
  TestWindings();
  TestMergedPoints();
  TestRepeatedPoints();
  TestConcave({ 0, 1, 2, 3, 4, 5 }, true);
  TestConcave({ 3, 4, 5, 0, 1, 2 }, true);
  TestConcave({ 1, 0, 2, 3, 4, 5 }, false);
  TestWarped();
  TestHangingPoints(VTK_DOUBLE);
  TestHangingPoints(VTK_FLOAT);
  TestChangedFaces();
  TestAmongOthers();
  return Result();
}
