#include "CellFuzz.h"

#include "CellAccount.h"
#include "CellSpoiler.h"
#include "CellZoo.h"
#include "ConvexCellsTesting.h"
#include "SeedRuns.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace
{
using namespace ConvexCellsTesting;
using CellFuzz::Grid;
using Ids = std::vector<vtkIdType>;

// Ids that are none stay so.
void Append(vtkUnstructuredGrid* grid, CellSpoiler::Cell cell)
{
  const vtkIdType first = grid->GetNumberOfPoints();
  const auto move = [&](Ids& ids)
  {
    for (vtkIdType& id : ids)
    {
      id += id < 0 ? 0 : first;
    }
  };
  for (const Point& x : cell.Points)
  {
    grid->GetPoints()->InsertNextPoint(x.data());
  }
  move(cell.Corners);
  std::for_each(cell.Sides.begin(), cell.Sides.end(), move);
  cell.Type == VTK_POLYHEDRON ? AddPolyhedron(grid, cell.Sides)
                              : AddCell(grid, cell.Type, cell.Corners);
}

void AddScalar(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> scalar;
  scalar->SetName("scalar");
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    const Point x = PointOf(grid, id);
    scalar->InsertNextValue(std::sin(x[0] + 2.0 * x[1] - x[2]));
  }
  grid->GetPointData()->SetScalars(scalar);
}

bool ReportFailures(unsigned int seed)
{
  Grid grid = CellFuzz::Mesh(seed);
  const std::string fault = CellFuzz::FindFault(grid);
  if (fault.empty())
  {
    return false;
  }
  std::cerr << "seed " << seed << ": " << fault << "\n";
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    Grid single = CellFuzz::Single(grid, cell);
    const std::string alone = CellFuzz::FindFault(single);
    std::cerr << (alone.empty() ? "" : alone + "\n" + CellFuzz::Print(single));
  }
  return true;
}
}

//------------------------------------------------------------------------------
CellFuzz::Grid CellFuzz::Mesh(unsigned int seed)
{
  CellSpoiler spoiler(seed);
  auto grid = MakeGrid({});
  for (const int type : CellZoo::AllTypes())
  {
    Append(grid, spoiler.Make(type));
  }
  Append(grid, spoiler.Make(VTK_POLYHEDRON));
  AddScalar(grid);
  return grid;
}

//------------------------------------------------------------------------------
CellFuzz::Grid CellFuzz::Single(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  auto single = Grid::New();
  single->SetPoints(grid->GetPoints());
  single->GetPointData()->ShallowCopy(grid->GetPointData());
  single->Allocate(1);
  vtkNew<vtkIdList> ids;
  if (grid->GetCellType(cell) == VTK_POLYHEDRON)
  {
    grid->GetFaceStream(cell, ids);
  }
  else
  {
    grid->GetCells()->GetCellAtId(cell, ids);
  }
  single->InsertNextCell(grid->GetCellType(cell), ids);
  return single;
}

//------------------------------------------------------------------------------
std::string CellFuzz::Print(vtkUnstructuredGrid* grid)
{
  std::ostringstream text;
  text.precision(17);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const bool isPolyhedron = grid->GetCellType(cell) == VTK_POLYHEDRON;
    isPolyhedron ? grid->GetFaceStream(cell, ids) : grid->GetCells()->GetCellAtId(cell, ids);
    text << "type " << grid->GetCellType(cell) << ", { ";
    std::copy(ids->begin(), ids->end(), std::ostream_iterator<vtkIdType>(text, ", "));
    text << "},\n";
    vtkNew<vtkIdList> corners;
    grid->GetCells()->GetCellAtId(cell, corners);
    for (const vtkIdType id : *corners)
    {
      if (id >= 0 && id < grid->GetNumberOfPoints())
      {
        const Point x = PointOf(grid, id);
        text << "  " << id << ": { " << x[0] << ", " << x[1] << ", " << x[2] << " },\n";
      }
    }
  }
  return text.str();
}

//------------------------------------------------------------------------------
std::string CellFuzz::FindFault(vtkUnstructuredGrid* grid)
{
  // Most curved cells go out as their linear twins, whose volume is known; some are cut.
  const bool isCut = grid->GetNumberOfPoints() % 128 == 0;
  CellAccount account(grid, isCut ? 0.3 : 1.0);
  for (const bool tetrahedraOnly : { false, true })
  {
    const std::string fault = account.FindFault(tetrahedraOnly);
    if (!fault.empty())
    {
      return (tetrahedraOnly ? "as tetrahedra: " : "as convex cells: ") + fault;
    }
  }
  return "";
}

//------------------------------------------------------------------------------
int CellFuzz::CountFailures(unsigned int first, unsigned int count)
{
  return SeedRuns::CountFailures(first, count, ReportFailures);
}
