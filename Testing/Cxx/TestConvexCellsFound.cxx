// What the random cells of TestCellFuzz came down to, by name; each was a fault once.
#include "CellFuzz.h"
#include "ConvexCellsTesting.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"

namespace
{
using namespace ConvexCellsTesting;

struct Found
{
  const char* Name;
  int Type;
  std::vector<Point> Points;
  vtkIdType Pieces; // of convex cells; below 0 where rounding may tell
};

const Found All[] = {
  // Two edges have each other's ends in their middles: halving had no end.
  { "edgesThatRunBack", VTK_QUADRATIC_PYRAMID,
    { { -2, -1, 0 }, { -2, -1, 2 }, { -2, -1, 3 }, { -2, -1, 1 }, { -3, -2, 1 }, { -2, -1, 1 },
      { -2, -1, 1 }, { -2, -1, 2 }, { -2, -1, 0 }, { -2, -1, 0 }, { -2, -1, 1 }, { -2, -1, 2 },
      { -2, -1, 2 } },
    -1 },
  // The products of its coordinates underflow, and no sign of the hull was right.
  { "tinyPointSet", VTK_CONVEX_POINT_SET,
    { { -2.512504035706176e-106, -1.4572055122179916e-106, 1.6206957186290217e-105 },
      { 1.6709664016585893e-105, -2.3198992376861066e-105, 2.040569702431266e-105 },
      { 1.1754295729656021e-105, -1.2308148637059872e-105, 1.4845794775054977e-105 },
      { 1.7849979689239788e-106, -4.3970368162287051e-106, 6.0286247651095099e-106 },
      { 1.1216919757511437e-105, 8.3594745947342803e-106, 2.490582092107863e-105 },
      { 2.8074612640170044e-105, -6.6074455167928887e-106, 4.153117868900229e-105 },
      { 2.6422873184561996e-105, -6.7083839151595223e-106, 2.1621705855280675e-105 },
      { -1.0853866650878296e-106, 8.7854013908008763e-106, 2.2852636151536873e-105 } },
    1 },
  // Two of its corners changed places: as a voxel it was taken for convex.
  { "tangledVoxel", VTK_VOXEL,
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 },
      { 1, 1, 1 } },
    -1 },
  // Flat but for its last digits: one tetrahedron had another sign than the cell.
  { "flatWedge", VTK_WEDGE,
    { { 0.53728758030754165, -0.34609311798054931, -1.1536437266047919 },
      { 0.26634248112770387, -0.20431279383253878, -0.68104264611421317 },
      { 0.32775522622550324, -0.27442856323412923, -0.91476187745131421 },
      { 0.022451159977578627, -0.47738235983258231, -1.591274532776686 },
      { -0.31615134810961476, -0.26193849592170193, -0.87312831974276472 },
      { -0.69156945059460939, -0.41390604395923952, -1.3796868131998135 } },
    -1 },
};

// Curved cells follow a scalar that no straight one has.
void Check(const Found& found)
{
  auto grid = MakeGrid(found.Points);
  std::vector<vtkIdType> ids;
  vtkNew<vtkDoubleArray> scalar;
  scalar->SetName("scalar");
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    ids.push_back(id);
    scalar->InsertNextValue(std::sin(3.0 * static_cast<double>(id)));
  }
  AddCell(grid, found.Type, ids);
  grid->GetPointData()->SetScalars(scalar);
  const std::string fault = CellFuzz::FindFault(grid);
  if (!CHECK_EQUAL(fault, std::string()))
  {
    std::cerr << "  " << found.Name << "\n";
  }
  for (const bool tetrahedraOnly : { false, true })
  {
    vtkNew<vtkConvexCells> filter;
    filter->SetInputData(grid);
    filter->SetTetrahedraOnly(tetrahedraOnly);
    filter->SetTolerance(0.1);
    filter->Update();
    const vtkIdType pieces = filter->GetOutput()->GetNumberOfCells();
    if (!CHECK(tetrahedraOnly || found.Pieces < 0 || pieces == found.Pieces))
    {
      std::cerr << "  " << found.Name << ": " << pieces << " pieces\n";
    }
  }
}
}

int TestConvexCellsFound(int, char*[])
{
  for (const Found& found : All)
  {
    Check(found);
  }
  return Result();
}
