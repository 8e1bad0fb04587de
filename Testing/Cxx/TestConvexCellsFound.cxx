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
  // Two corners across a face are one point: a triangle of its fan has two corners only.
  { "faceThatTouchesItself", VTK_HEXAGONAL_PRISM,
    { { 0, 0, 1 }, { -.6, .3, 1 }, { -.6, -.3, 1 }, { 0, 0, 1 }, { .6, -.3, 1.2 }, { .6, .3, 1 },
      { .5, .866, 0 }, { -.5, .866, 0 }, { -1, 0, 0 }, { -.5, -.866, 0 }, { .5, -.866, 0 },
      { 1, 0, 0 } },
    -1 },
  // A millionth as thick as wide, and tangled: what was dropped as flat was as much as the rest.
  { "flatTangledHexahedron", VTK_HEXAHEDRON,
    { { 0.30000099999999996, 1, -1 }, { 0.29999999999999999, 1, -2 },
      { -9.9999999999999995e-07, -0, -0 }, { -0.29999900000000002, -1, 0 },
      { -0.29999799999999999, -1, -1 }, { 0, 0, -4 }, { -0.60000100000000001, -2, -2 },
      { -0.59999999999999998, -2, 0 } },
    -1 },
  // Such a face with three corners in a row: no cut keeps to the triangles, and it was not
  // counted.
  { "faceInARowThatTouchesItself", VTK_HEXAGONAL_PRISM,
    { { -1, 2, -0 }, { -0, 2, -0 }, { 0, 1, -1 }, { 1, 0, -2 }, { 0, 1, -2 }, { -0, 1, -1 },
      { -1, 1, 2 }, { -0, 0, 2 }, { 0, -0, 1 }, { 1, -1, 0 }, { 0, -1, 0 }, { 0, -1, 0 } },
    -1 },
  // No point sees all of it, a corner all but 3e-7, which was dropped without a word.
  { "cornerOnAFace", VTK_PENTAGONAL_PRISM,
    { { -0.64373110071383377, 0.061035139679106565, 0.93854944101026749 },
      { -0.36782365313006765, 0.44392317085884692, 1.2002087623371722 },
      { -0.22865404209741419, 0.15758386292718415, 0.86638814312651824 },
      { -0.41855027752111634, -0.4022708981408617, 0.39841714291165087 },
      { -0.67508233511319948, -0.46194198199901926, 0.44301473697092597 },
      { -0.55580304427524685, 0.56883890847314389, 1.4491396844102875 },
      { -0.27989559669148073, 0.95172693965288424, 1.7107990057371922 },
      { -0.14072598565882727, 0.66538763172122151, 1.3769783865265381 },
      { -0.33062222108252942, 0.10553287065317563, 0.90900738631167088 },
      { -0.32682329320084891, 0.16890452766023933, 0.96905373425811325 } },
    -1 },
};

// Of a straight cell, by the faces that VTK gives.
void AddAsPolyhedron(vtkUnstructuredGrid* grid, int type, const std::vector<vtkIdType>& ids)
{
  auto alone = MakeGrid({});
  alone->SetPoints(grid->GetPoints());
  AddCell(alone, type, ids);
  vtkCell* cell = alone->GetCell(0);
  Faces faces;
  for (int face = 0; face < cell->GetNumberOfFaces(); ++face)
  {
    vtkIdList* corners = cell->GetFace(face)->GetPointIds();
    faces.emplace_back(corners->begin(), corners->end());
  }
  AddPolyhedron(grid, faces);
}

// Curved cells follow a scalar that no straight one has.
void Check(const Found& found, bool asPolyhedron)
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
  asPolyhedron ? AddAsPolyhedron(grid, found.Type, ids) : AddCell(grid, found.Type, ids);
  grid->GetPointData()->SetScalars(scalar);
  const std::string fault = CellFuzz::FindFault(grid);
  if (!CHECK_EQUAL(fault, std::string()))
  {
    std::cerr << "  " << found.Name << (asPolyhedron ? " as a polyhedron\n" : "\n");
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
    Check(found, false);
    if (found.Type == VTK_HEXAHEDRON || found.Type == VTK_WEDGE ||
      found.Type == VTK_PENTAGONAL_PRISM || found.Type == VTK_HEXAGONAL_PRISM)
    {
      Check(found, true);
    }
  }
  return Result();
}
