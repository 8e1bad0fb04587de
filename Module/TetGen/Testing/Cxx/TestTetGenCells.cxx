// CellByCell: polyhedra that no point sees all of, beside hexahedra and each other.

#include "ConvexCellsTesting.h"
#include "TetrahedraCheck.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkTetGenTetrahedralizer.h"

#include <cmath>

using namespace ConvexCellsTesting;

namespace
{
// A U of two prongs, counter-clockwise; its gap is the square (1, 1) .. (2, 4).
const double Outline[8][2] = { { 0, 0 }, { 3, 0 }, { 3, 4 }, { 2, 4 }, { 2, 1 }, { 1, 1 }, { 1, 4 },
  { 0, 4 } };
constexpr double AreaOfU = 9.0;
constexpr double AreaOfGap = 3.0;

// Floors 0, 1 and 3: a U, another on it, a hexahedron in the gap of the lower one, a tetrahedron
// that meets nothing. `first` shifts where the outline begins, so that other ids are the smallest.
vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(int first)
{
  std::vector<Point> points;
  for (const double z : { 0.0, 1.0, 3.0 })
  {
    for (int i = 0; i < 8; ++i)
    {
      const double* corner = Outline[(i + first) % 8];
      points.push_back({ corner[0], corner[1], z });
    }
  }
  points.insert(points.end(), { { 9, 9, 9 }, { 8, 9, 9 }, { 9, 8, 9 }, { 9, 9, 8 } });
  auto grid = MakeGrid(points);
  for (const int floor : { 0, 8 })
  {
    Faces faces(2);
    for (int i = 0; i < 8; ++i)
    {
      const vtkIdType a = floor + i, b = floor + (i + 1) % 8;
      faces.push_back({ a, b, b + 8, a + 8 });
      faces[0].push_back(floor + 7 - i);
      // Wound inward: files cannot be trusted.
      faces[1].push_back(floor + 8 + 7 - i);
    }
    AddPolyhedron(grid, faces);
  }
  const auto id = [first](int corner) { return vtkIdType((corner + 8 - first) % 8); };
  AddCell(grid, VTK_HEXAHEDRON,
    { id(5), id(4), id(3), id(6), id(5) + 8, id(4) + 8, id(3) + 8, id(6) + 8 });
  AddCell(grid, VTK_TETRA, { 24, 25, 26, 27 });
  TetrahedraCheck::AddLinear(grid);
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  for (const double value : { 10.0, 20.0, 30.0, 40.0 })
  {
    values->InsertNextValue(value);
  }
  grid->GetCellData()->AddArray(values);
  return grid;
}

void TestPolyhedra(int first)
{
  const auto grid = MakeMesh(first);
  vtkNew<vtkTetGenTetrahedralizer> filter;
  filter->SetInputData(grid);
  filter->Update();
  vtkUnstructuredGrid* output = filter->GetOutput();
  CHECK_EQUAL(filter->GetNumberOfCutCells(), 2);
  CHECK_EQUAL(filter->GetNumberOfFailedCells(), 0);
  CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0);
  const std::vector<double> volumes = TetrahedraCheck::VolumesBySource(output, 4);
  CHECK(Near(volumes[0], AreaOfU, 1e-10));
  CHECK(Near(volumes[1], 2.0 * AreaOfU, 1e-10));
  CHECK(Near(volumes[2], AreaOfGap, 1e-10));
  CHECK(Near(volumes[3], 1.0 / 6.0, 1e-10));
  CHECK_EQUAL(volumes[4], 0.0);
  CHECK(Near(TotalVolume(output), 3.0 * AreaOfU + AreaOfGap + 1.0 / 6.0, 1e-10));
  const TetrahedraCheck::Faces faces = TetrahedraCheck::CountFaces(output);
  CHECK_EQUAL(faces.Wrong, 0);
  // The lower floor is a whole rectangle; the upper U stands on it. Any unmatched face adds area.
  const double lower = 2.0 * 12.0 + 14.0, upper = 2.0 * AreaOfU + 2.0 * 20.0;
  const double tetrahedron = 1.5 + std::sqrt(3.0) / 2.0;
  CHECK(Near(faces.BoundaryArea, lower + upper - 2.0 * AreaOfU + tetrahedron, 1e-10));
  CHECK(TetrahedraCheck::LinearError(output) < 1e-12);
  vtkDataArray* values = output->GetCellData()->GetArray("value");
  vtkDataArray* sources = output->GetCellData()->GetArray("SourceCell");
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    CHECK(values->GetTuple1(i) == 10.0 + 10.0 * sources->GetTuple1(i));
    CHECK(i == 0 || sources->GetTuple1(i - 1) <= sources->GetTuple1(i));
  }
}
}

int TestTetGenCells(int, char*[])
{
  for (int first = 0; first < 8; ++first)
  {
    TestPolyhedra(first);
  }
  return Result();
}
