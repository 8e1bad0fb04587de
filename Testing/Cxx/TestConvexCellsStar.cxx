// Cells that no corner sees all of, but a point within does: cut from that point, with the volume
// of the cell, the triangles of its faces, and linear data.
#include "CellZoo.h"
#include "ConvexCellsTesting.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace
{
using namespace ConvexCellsTesting;

double Field(const Point& x)
{
  return 1.0 + x[0] - 2.0 * x[1] + 0.5 * x[2];
}

void AddField(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    values->InsertNextValue(Field(PointOf(grid, id)));
  }
  grid->GetPointData()->SetScalars(values);
}

// A prism over a star: seen whole from its middle, and from no corner.
vtkSmartPointer<vtkUnstructuredGrid> Star(int tips, double inner, int precision, double scale)
{
  std::vector<Point> points;
  Faces faces;
  const int count = 2 * tips;
  const auto n = static_cast<vtkIdType>(count);
  for (int i = 0; i < 2 * count; ++i)
  {
    const double angle = 3.14159265358979323846 * i / tips, radius = i % 2 ? inner : 1.0;
    points.push_back({ scale * radius * std::cos(angle), scale * radius * std::sin(angle),
      scale * (i < count ? -1.0 : 1.0) });
  }
  Faces middles(2);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const vtkIdType next = (i + 1) % n, before = (i + n - 1) % n;
    faces.push_back({ i, next, next + n, i + n });
    for (const vtkIdType level : { vtkIdType{ 0 }, n })
    {
      if (i % 2)
      {
        middles[level / n].push_back(i + level);
        continue;
      }
      faces.push_back({ before + level, i + level, next + level });
    }
  }
  faces.insert(faces.end(), middles.begin(), middles.end());
  auto grid = MakeGrid(points, precision);
  AddPolyhedron(grid, faces);
  AddField(grid);
  return grid;
}

void TestStar(int tips, int precision, double scale)
{
  auto grid = Star(tips, 0.3, precision, scale);
  const double area = tips * 0.3 * std::sin(3.14159265358979323846 / tips);
  const double volume = 2.0 * area * scale * scale * scale;
  const int triangles = 8 * tips - 4;
  for (const bool tetrahedraOnly : { false, true })
  {
    auto filter = Run(grid, tetrahedraOnly);
    vtkUnstructuredGrid* output = filter->GetOutput();
    CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0);
    CHECK_EQUAL(filter->GetNumberOfNonConvexCells(), tetrahedraOnly ? 0 : 1);
    CHECK_EQUAL(output->GetNumberOfCells(), triangles);
    CHECK_EQUAL(output->GetNumberOfPoints(), grid->GetNumberOfPoints() + 1);
    CHECK(Near(TotalVolume(output), volume, precision == VTK_FLOAT ? 1e-6 : 1e-12));
    const CellZoo::FaceUses uses = CellZoo::CountFaceUses(output);
    CHECK_EQUAL(uses.Once, triangles);
    CHECK_EQUAL(uses.More, 0);
    const vtkIdType last = output->GetNumberOfPoints() - 1;
    const double made = output->GetPointData()->GetScalars()->GetTuple1(last);
    CHECK(std::abs(made - Field(PointOf(output, last))) < 1e-6 * std::max(1.0, scale));
    vtkTable* report = filter->GetReport();
    CHECK_EQUAL(report->GetNumberOfRows(), 1);
    CHECK_EQUAL(report->GetValueByName(0, "why").ToString(),
      std::string("no corner sees all: cut from a point within"));
  }
}

// Folded from every corner, and from a point within not. Its neighbour keeps the face between.
void TestHexahedron(bool insideOut)
{
  auto grid = MakeGrid({ { -.3, .2, .2 }, { .7, 0, .5 }, { .8, 1.4, -.3 }, { .1, .4, -.5 },
    { .3, .4, .6 }, { 1, -.5, .5 }, { 1, 1, 1.3 }, { -.2, 1.3, 1.5 }, { 3, 0, .2 },
    { 3, 1.4, -.2 }, { 3, -.4, .8 }, { 3, 1, 1.2 } });
  std::vector<vtkIdType> ids = { 0, 1, 2, 3, 4, 5, 6, 7 };
  if (insideOut)
  {
    ids = { 4, 5, 6, 7, 0, 1, 2, 3 };
  }
  AddCell(grid, VTK_HEXAHEDRON, ids);
  AddCell(grid, VTK_HEXAHEDRON, { 1, 8, 9, 2, 5, 10, 11, 6 });
  AddField(grid);
  auto filter = Run(grid, true);
  vtkUnstructuredGrid* output = filter->GetOutput();
  CHECK_EQUAL(filter->GetNumberOfFoldedCells(), 0);
  CHECK_EQUAL(output->GetNumberOfPoints(), 13);
  CHECK_EQUAL(filter->GetNumberOfInvertedCells(), insideOut ? 1 : 0);
  CHECK(Near(TotalVolume(output), std::abs(VolumeWithin(grid->GetCell(0))) +
                                    VolumeWithin(grid->GetCell(1)), 1e-12));
  const CellZoo::FaceUses uses = CellZoo::CountFaceUses(output);
  CHECK_EQUAL(uses.Once, 20);
  CHECK_EQUAL(uses.More, 0);
  for (vtkIdType id = 12; id < output->GetNumberOfPoints(); ++id)
  {
    CHECK(std::abs(output->GetPointData()->GetScalars()->GetTuple1(id) -
            Field(PointOf(output, id))) < 1e-12);
  }
}

// New values on the same cells: the added point follows, and the cells stay.
void TestNewData()
{
  auto grid = Star(5, 0.3, VTK_DOUBLE, 1.0);
  auto filter = Run(grid, true);
  const vtkMTimeType before = filter->GetOutput()->GetCells()->GetMTime();
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  values->SetNumberOfValues(grid->GetNumberOfPoints());
  values->FillValue(7.0);
  grid->GetPointData()->SetScalars(values);
  grid->Modified();
  filter->Update();
  vtkUnstructuredGrid* output = filter->GetOutput();
  CHECK_EQUAL(output->GetCells()->GetMTime(), before);
  CHECK(Near(output->GetPointData()->GetScalars()->GetTuple1(output->GetNumberOfPoints() - 1), 7.0));
}
}

int TestConvexCellsStar(int, char*[])
{
  for (const int tips : { 5, 8, 300, 1000 })
  {
    TestStar(tips, VTK_DOUBLE, 1.0);
    TestStar(tips, VTK_DOUBLE, 1e-6);
  }
  TestStar(5, VTK_FLOAT, 1.0);
  TestStar(5, VTK_DOUBLE, 1e6);
  TestHexahedron(false);
  TestHexahedron(true);
  TestNewData();
  return Result();
}
