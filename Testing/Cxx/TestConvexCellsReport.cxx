// The table of what became of which cells: every input cell in one row, by type and reason.
#include "CellZoo.h"
#include "ConvexCellsTesting.h"

#include "vtkCellData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <string>

namespace
{
using namespace ConvexCellsTesting;

struct Row
{
  const char* Type;
  const char* Why;
  vtkIdType In, Out, Dropped;
};

void CheckRow(vtkTable* report, const Row& expected)
{
  int found = 0;
  for (vtkIdType row = 0; row < report->GetNumberOfRows(); ++row)
  {
    if (report->GetValueByName(row, "type").ToString() == expected.Type &&
        report->GetValueByName(row, "why").ToString() == expected.Why)
    {
      ++found;
      CHECK_EQUAL(report->GetValueByName(row, "in").ToLongLong(), expected.In);
      CHECK_EQUAL(report->GetValueByName(row, "out").ToLongLong(), expected.Out);
      CHECK_EQUAL(report->GetValueByName(row, "dropped").ToLongLong(), expected.Dropped);
    }
  }
  if (!CHECK_EQUAL(found, 1))
  {
    std::cerr << "  " << expected.Type << ", " << expected.Why << "\n";
  }
}

vtkSmartPointer<vtkUnstructuredGrid> MakeAssortment()
{
  auto grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { std::nan(""), 0, 0 }, { -.5, -.5, -.5 } });
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 4, 4, 4 });
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6 });
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 9, 7 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 4 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 8 });
  AddCell(grid, VTK_TETRA, { 0, 1, 2, 3 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 4 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 4 });
  AddCell(grid, VTK_QUAD, { 0, 1, 2, 3 });
  AddCell(grid, VTK_LINE, { 0, 1 });
  AddCell(grid, VTK_VERTEX, { 0 });
  AddCell(grid, VTK_EMPTY_CELL, {});
  AddCell(grid, VTK_QUADRATIC_TRIANGLE, { 0, 1, 2, 3, 4, 5 });
  AddCell(grid, 250, { 0, 1 });
  AddPolyhedron(grid, { { 0, 1, 2 }, { 0, 1, 4 } });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(grid->GetNumberOfCells());
  ghosts->FillValue(0);
  ghosts->SetValue(7, vtkDataSetAttributes::DUPLICATECELL);
  ghosts->SetValue(8, vtkDataSetAttributes::HIDDENCELL);
  grid->GetCellData()->AddArray(ghosts);
  return grid;
}

void CheckSums(vtkConvexCells* filter, vtkUnstructuredGrid* input)
{
  vtkTable* report = filter->GetReport();
  vtkIdType in = 0, out = 0, dropped = 0;
  for (vtkIdType row = 0; row < report->GetNumberOfRows(); ++row)
  {
    in += report->GetValueByName(row, "in").ToLongLong();
    out += report->GetValueByName(row, "out").ToLongLong();
    dropped += report->GetValueByName(row, "dropped").ToLongLong();
  }
  CHECK_EQUAL(in, input->GetNumberOfCells());
  CHECK_EQUAL(out, filter->GetOutput()->GetNumberOfCells());
  CHECK_EQUAL(dropped, filter->GetNumberOfSkippedCells());
}

void TestAssortment()
{
  auto grid = MakeAssortment();
  auto filter = Run(grid, false);
  vtkTable* report = filter->GetReport();
  CheckSums(filter, grid);
  for (const Row& row : { Row{ "vtkHexahedron", "", 1, 1, 0 },
         Row{ "vtkHexahedron", "repeats a point or is flat", 1, 2, 0 },
         Row{ "vtkHexahedron", "wrong list of points", 1, 0, 1 }, Row{ "vtkTetra", "", 1, 1, 0 },
         Row{ "vtkTetra", "a point that is not finite", 1, 0, 1 },
         Row{ "vtkTetra", "zero volume", 1, 0, 1 }, Row{ "vtkTetra", "duplicate", 1, 0, 1 },
         Row{ "vtkTetra", "hidden, or with a hidden point", 1, 0, 1 },
         Row{ "vtkQuad", "2-D", 1, 0, 1 }, Row{ "vtkLine", "1-D", 1, 0, 1 },
         Row{ "vtkVertex", "0-D", 1, 0, 1 }, Row{ "vtkEmptyCell", "0-D", 1, 0, 1 },
         Row{ "vtkQuadraticTriangle", "2-D", 1, 0, 1 },
         Row{ "of type 250", "not supported", 1, 0, 1 },
         Row{ "vtkPolyhedron", "open surface", 1, 0, 1 } })
  {
    CheckRow(report, row);
  }
  CHECK_EQUAL(report->GetNumberOfRows(), 16);
  filter->SetInputData(MakeGrid({}));
  filter->Update();
  CHECK_EQUAL(filter->GetReport()->GetNumberOfRows(), 0);
}

void TestCurved()
{
  const int size[3] = { 3, 1, 1 };
  auto grid = CellZoo::Make(size,
    { CellZoo::QuadraticHexahedron, CellZoo::Hexahedron, CellZoo::Hexahedron },
    [](const double x[3]) { return x[0] < 1.5 ? x[1] * x[1] : x[1]; });
  auto filter = Run(grid, false);
  CheckSums(filter, grid);
  CHECK_EQUAL(filter->GetReport()->GetNumberOfRows(), 3);
  vtkTable* report = filter->GetReport();
  CHECK_EQUAL(report->GetValueByName(0, "why").ToString(), std::string());
  CHECK_EQUAL(report->GetValueByName(1, "why").ToString(),
    std::string("next to a curved cell that was cut"));
  CHECK_EQUAL(report->GetValueByName(2, "why").ToString(),
    std::string("curved: follows the tolerance"));
  CHECK(report->GetValueByName(2, "out").ToInt() > 20);
}
}

int TestConvexCellsReport(int, char*[])
{
  TestAssortment();
  TestCurved();
  return Result();
}
