// M10, M11: cells that cannot be drawn are counted and named in one message, and the rest is drawn
// as if they were not there.

#include "ConvexCellsTesting.h"
#undef CHECK

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <cmath>
#include <functional>

namespace
{
using ConvexCellsTesting::AddCell;
using ConvexCellsTesting::AddPolyhedron;
using ConvexCellsTesting::BoxFaces;
using ConvexCellsTesting::Faces;

// A bad cell beside 27 good ones, and what the message calls it.
struct BadCell
{
  const char* Said;
  std::function<void(vtkUnstructuredGrid*)> Add;
};

Faces WithoutLast(Faces faces)
{
  faces.pop_back();
  return faces;
}

std::vector<BadCell> BadCells()
{
  const std::vector<vtkIdType> box = { 0, 1, 5, 4, 16, 17, 21, 20 };
  return {
    { "1 vtkTriangle",
      [](vtkUnstructuredGrid* grid) {
        AddCell(grid, VTK_TRIANGLE, { 0, 1, 2 });
      } },
    { "1 vtkVertex", [](vtkUnstructuredGrid* grid) { AddCell(grid, VTK_VERTEX, { 3 }); } },
    { "1 of type 200",
      [](vtkUnstructuredGrid* grid) {
        AddCell(grid, 200, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 });
      } },
    { "1 vtkPolyhedron (open surface)",
      [=](vtkUnstructuredGrid* grid) { AddPolyhedron(grid, WithoutLast(BoxFaces(box))); } },
    // The last face names a corner that the others do not.
    { "1 vtkPolyhedron (open surface)",
      [=](vtkUnstructuredGrid* grid)
      {
        Faces faces = BoxFaces(box);
        faces.back()[0] = 63;
        AddPolyhedron(grid, faces);
      } },
    { "1 of zero volume",
      [](vtkUnstructuredGrid* grid) {
        AddPolyhedron(grid, { { 0, 1, 2 }, { 0, 2, 1 } });
      } },
    { "1 of zero volume",
      [](vtkUnstructuredGrid* grid) {
        AddCell(grid, VTK_HEXAHEDRON, { 0, 0, 0, 0, 0, 0, 0, 0 });
      } },
  };
}

void CheckBadCell(TestChecks& checks, const PolyhedraMappers::Entry& mapper, const BadCell& bad)
{
  PolyhedraScene scene(mapper.Make(), 96, 96);
  auto grid = PolyhedraMeshes::Hexahedra(3);
  scene.SetMesh(grid);
  scene.Render();
  auto without = scene.CopyCaptured();
  checks.Check(scene.CountLitPixels() > 1000, "something is drawn", __LINE__);
  bad.Add(grid);
  grid->Modified();
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.Render();
  scene.Render();
  const std::string name = mapper.Name + ", " + bad.Said;
  checks.Check(messages->Count() == 1 && messages->CountOf(bad.Said) == 1, name.c_str(), __LINE__,
    messages->Texts.empty() ? "silence" : messages->Texts[0]);
  const double difference = TestScene::Difference(without, scene.Mapper->GetCapturedImage());
  checks.Check(difference == 0.0, name.c_str(), __LINE__, std::to_string(difference));
  checks.Check(scene.GetStatistic("CellsIn") == 28, "CellsIn", __LINE__);
  checks.Check(scene.GetStatistic("CellsDrawn") == 27, "CellsDrawn", __LINE__,
    std::to_string(scene.GetStatistic("CellsDrawn")));
  checks.Check(scene.GetStatistic("CellsSkippedInvalid") == 1, "CellsSkippedInvalid", __LINE__,
    std::to_string(scene.GetStatistic("CellsSkippedInvalid")));
}

// Concave: a hexahedron with a corner pushed beyond its middle is cut up, silently, and exact.
void CheckConcave(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make(), 96, 96);
  auto grid = PolyhedraMeshes::Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint((i % 4 == 1 || i % 4 == 2) - 0.5, i % 4 / 2 - 0.5, i / 4 - 0.5);
  }
  points->SetPoint(6, 0.05, 0.06, 0.04);
  grid->SetPoints(points);
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
  PolyhedraMeshes::SetWaves(grid);
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.SetMesh(grid);
  for (const int view : { 0, 1 })
  {
    scene.SetView(view);
    scene.CheckWithOracle(checks, mapper.Name + ", concave hexahedron", __LINE__);
  }
  checks.Check(messages->Count() == 0, "silent", __LINE__);
  checks.Check(scene.GetStatistic("CellsIn") == 1, "CellsIn", __LINE__);
  checks.Check(scene.GetStatistic("CellsDrawn") > 1, "it is cut up", __LINE__);
}

void CheckNoInput(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make());
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.Render();
  scene.Render();
  checks.Check(messages->CountOf("No input") == 1, "No input", __LINE__);
  vtkNew<vtkUnstructuredGrid> empty;
  scene.Mapper->SetInputData(empty);
  scene.Render();
  scene.Render();
  checks.Check(messages->CountOf("0 points and 0 cells") == 1, "0 points", __LINE__);
  auto grid = PolyhedraMeshes::Hexahedra(2);
  grid->GetPointData()->Initialize();
  scene.Mapper->SetInputData(grid);
  scene.Render();
  checks.Check(messages->CountOf("no active scalars") == 1, "scalars", __LINE__);
  checks.Check(messages->Count() == 3, "three messages", __LINE__);
  // And recovers.
  scene.Mapper->SetInputData(PolyhedraMeshes::Hexahedra(2));
  scene.Render();
  checks.Check(scene.CountLitPixels() > 1000, "drawn", __LINE__);
}
}

int TestPolyhedraBadInput(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    for (const BadCell& bad : BadCells())
    {
      CheckBadCell(checks, mapper, bad);
    }
    CheckNoInput(checks, mapper);
  }
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
  {
    CheckConcave(checks, mapper);
  }
  return checks.Result();
}
