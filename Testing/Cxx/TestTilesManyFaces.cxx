// A convex cell of any number of faces by the Tiles engine for emission: what shines a thousand times as brightly is
// set up in double, and its image is that of floats a thousand times.

#include "EmissionTilesEngine.h"
#include "HexahedraArrays.h"
#include "TestScene.h"
#include "TileArrays.h"

#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Brighter = 1000.0;

// Two cones of so many triangles each.
vtkSmartPointer<vtkUnstructuredGrid> MakeCones(int sides)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdList> faces;
  points->InsertNextPoint(0.0, 0.0, -0.7);
  points->InsertNextPoint(0.0, 0.0, 0.8);
  faces->InsertNextId(2 * sides);
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / sides;
    points->InsertNextPoint(0.8 * std::cos(angle), 0.8 * std::sin(angle), 0.0);
    for (const int end : { 0, 1 })
    {
      faces->InsertNextId(3);
      faces->InsertNextId(end);
      faces->InsertNextId(2 + (end == 0 ? (i + 1) % sides : i));
      faces->InsertNextId(2 + (end == 0 ? i : (i + 1) % sides));
    }
  }
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_POLYHEDRON, faces);
  return grid;
}

HexahedraArrays MakeArrays(vtkUnstructuredGrid* grid)
{
  HexahedraArrays arrays(1);
  arrays.Points.clear();
  arrays.Scalars.clear();
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double x[3];
    grid->GetPoint(id, x);
    for (const double k : { x[0], x[1], x[2], 0.0 })
    {
      arrays.Points.push_back(static_cast<float>(k));
    }
    arrays.Scalars.push_back(static_cast<float>(0.5 + 0.4 * x[0] - 0.1 * x[2]));
  }
  arrays.Cells = ConvexCellFaces();
  arrays.Cells.Build(grid);
  arrays.Pieces = FacePieces();
  arrays.Pieces.Build(arrays.Points, arrays.Cells.Loops);
  arrays.Planes = CellPlanes();
  arrays.Planes.Build(arrays.Points, arrays.Cells, arrays.Pieces);
  return arrays;
}

std::vector<float> Draw(TestChecks& checks, EmissionTilesEngine& engine, double unitDistance)
{
  TileArrays arrays(1);
  arrays.SetFunction(false, unitDistance);
  arrays.LookFrom({ 1.3, 2.1, 1.7 }, 35.0, 100, 90);
  ConvexTilesFrame::Scene scene;
  scene.Camera = arrays.Scene.Camera;
  scene.Function = arrays.Scene.Function;
  CHECK(engine.Render(scene));
  return engine.GetImage();
}
}

int TestTilesManyFaces(int, char*[])
{
  TestChecks checks;
  for (const int sides : { 5, 16, 17, 40, 150 })
  {
    const HexahedraArrays arrays = MakeArrays(MakeCones(sides));
    EmissionTilesEngine engine;
    arrays.SetMesh(engine);
    engine.SetScalars(arrays.Scalars, false);
    engine.SetDrawn(arrays.Drawn);
    std::vector<float> bright = Draw(checks, engine, 10.0 / Brighter);
    const std::vector<float> dim = Draw(checks, engine, 10.0);
    std::transform(bright.begin(), bright.end(), bright.begin(),
      [](float x) { return x / static_cast<float>(Brighter); });
    const double difference = TileArrays::LargestDifference(bright, dim);
    const double greatest = *std::max_element(dim.begin(), dim.end());
    std::cout << 2 * sides << " faces: " << greatest << ", off by " << difference << "\n";
    CHECK(greatest > 0.01);
    CHECK_AT_MOST(difference, 1e-5 * greatest);
  }
  return checks.Result();
}
