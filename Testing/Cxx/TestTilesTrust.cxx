// Tiles that rays enter once, and whose faces say for certain what comes first, draw the same bytes without
// the proof of each pixel: most of a lattice. Gaps, cells that overlap or are folded or flat, circles, orders
// from elsewhere, eyes inside and clipping planes keep the proof where they need it. That the images are the
// oracle's is for the other tests of Tiles, which trust as well.

#include "SortMeshes.h"
#include "TileArrays.h"
#include "TilesScene.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkTriangle.h"
#include "vtkUnstructuredGrid.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <random>
#include <string>

namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

Grid WithScalar(Grid grid)
{
  SortMeshes::AddScalar(grid);
  return grid;
}

Grid Lattice(int cells)
{
  return SortMeshes::Kuhn(SortMeshes::JitteredLattice(cells, 0.2));
}

// The share of the fragments that were not proven; without trust the image is the same to the last byte,
// but where the depths of faces seen nearly edge-on are rounded differently: by up to `rounding`.
double CheckView(TestChecks& checks, TilesScene& scene, double rounding = 1e-5)
{
  scene.EndsEarly = false;
  CHECK(scene.DrawTiles());
  const std::vector<float> trusting = scene.Engine.GetImage();
  const TileCounts counts = scene.Engine.GetCounts();
  scene.TrustsOrder = false;
  CHECK(scene.DrawTiles());
  const long long more = scene.Engine.GetCounts().RepairedPixels - counts.RepairedPixels;
  CHECK(scene.Engine.GetCounts().TrustedFragments == 0);
  CHECK(more >= 0);
  const double change = TileArrays::LargestDifference(scene.Engine.GetImage(), trusting);
  CHECK_AT_MOST(change, more > 0 ? rounding : 0.0);
  scene.TrustsOrder = scene.EndsEarly = true;
  return static_cast<double>(counts.TrustedFragments) /
    static_cast<double>(std::max(counts.Fragments, 1LL));
}

// Some eyes about a mesh, in both projections; returns the share of all.
double CheckMesh(TestChecks& checks, vtkUnstructuredGrid* grid, const std::string& name)
{
  TilesScene scene(260, 230);
  scene.SetTetrahedra(grid);
  scene.SetSmooth();
  scene.Property->SetScalarOpacityUnitDistance(0.1 * grid->GetLength());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  double sum = 0.0;
  constexpr int views = 3;
  for (int i = 0; i < views; ++i)
  {
    scene.LookAt(grid, { any(random), any(random), any(random) }, 1.2);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(i % 3 == 2);
    camera->SetParallelScale(0.5 * grid->GetLength());
    sum += CheckView(checks, scene) / views;
  }
  std::cout << name << ": trusted " << sum << "\n";
  return sum;
}

void CheckMeshes(TestChecks& checks)
{
  CHECK(CheckMesh(checks, WithScalar(Lattice(24)), "lattice") > 0.5);
  CHECK(CheckMesh(checks, WithScalar(SortMeshes::FineRing()), "ring") > 0.1);
  CheckMesh(checks, WithScalar(SortMeshes::FineBars()), "bars");
  CheckMesh(checks, WithScalar(SortMeshes::Tetrahedra(SortMeshes::Slabs())), "slabs");
  CheckMesh(checks, WithScalar(SortMeshes::Tetrahedra(SortMeshes::Checkerboard())), "checkerboard");
  CheckMesh(checks, WithScalar(SortMeshes::Tetrahedra(SortMeshes::HollowSphere())), "hollow sphere");
  CheckMesh(checks, WithScalar(SortMeshes::Tetrahedra(SortMeshes::Spring())), "spring");
}

// Every ray that enters both enters twice.
void CheckOverlap(TestChecks& checks)
{
  const Grid first = Lattice(6);
  const double size = 0.3 * first->GetLength();
  const Grid both = WithScalar(SortMeshes::Join(first, SortMeshes::Moved(Lattice(6), size, 0.2 * size, 0.1 * size)));
  TilesScene scene(60, 60);
  scene.SetTetrahedra(both);
  scene.SetSmooth();
  scene.LookAt(both, { 0.9, 0.5, 0.4 }, 1.2);
  CHECK(CheckView(checks, scene) == 0.0);
  CHECK(scene.Engine.GetCounts().RepairedPixels > 0);
}

// A lattice in which one point has moved through a face, and one whose point lies on one.
void CheckFolded(TestChecks& checks)
{
  for (const double far : { 1.0, 1.6 })
  {
    const Grid grid = SortMeshes::Kuhn(SortMeshes::Lattice(4));
    vtkPoints* points = grid->GetPoints();
    const vtkIdType middle = grid->FindPoint(grid->GetCenter());
    double at[3], beside[3];
    points->GetPoint(middle, at);
    points->GetPoint(middle + 1, beside);
    for (int k = 0; k < 3; ++k)
    {
      at[k] += far * (beside[k] - at[k]);
    }
    points->SetPoint(middle, at);
    TilesScene scene(60, 60);
    scene.SetTetrahedra(WithScalar(grid));
    scene.SetSmooth();
    scene.LookAt(grid, { 0.6, 0.5, 0.7 }, 1.2);
    CHECK(CheckView(checks, scene) == 0.0);
  }
}

// Faces seen edge-on, of which neither cell knows the side; and a plane that no ray needs.
void CheckDoubt(TestChecks& checks)
{
  const Grid grid = WithScalar(SortMeshes::Kuhn(SortMeshes::Lattice(8)));
  TilesScene scene(60, 60);
  scene.SetTetrahedra(grid);
  scene.SetSmooth();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetParallelProjection(1);
  camera->SetParallelScale(0.5 * grid->GetLength());
  scene.LookAt(grid, { 0.0, 0.0, 1.0 }, 1.2);
  CHECK(CheckView(checks, scene) == 0.0);
  scene.LookAt(grid, { 0.5, 0.3, 0.8 }, 1.2);
  CHECK(CheckView(checks, scene) == 1.0);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(grid->GetCenter());
  plane->SetNormal(0.0, 0.6, 0.8);
  scene.Mapper->AddClippingPlane(plane);
  CHECK(CheckView(checks, scene) == 0.0);
}

// From within the plane of a cell's face, with the line that it is seen as slanted through pixels.
void LookAlongFace(vtkCamera* camera, vtkUnstructuredGrid* grid, vtkIdType cell, std::mt19937& random, double slant)
{
  double corners[3][3], along[3], eye[3], normal[3], up[3];
  for (int i = 0; i < 3; ++i)
  {
    grid->GetPoint(grid->GetCell(cell)->GetPointId(i), corners[i]);
  }
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const double a = any(random), b = any(random);
  for (int k = 0; k < 3; ++k)
  {
    along[k] = a * (corners[1][k] - corners[0][k]) + b * (corners[2][k] - corners[0][k]);
  }
  vtkMath::Normalize(along);
  vtkTriangle::ComputeNormal(corners[0], corners[1], corners[2], normal);
  vtkMath::Cross(normal, along, up);
  for (int k = 0; k < 3; ++k)
  {
    eye[k] = corners[0][k] + 1.5 * grid->GetLength() * along[k];
    up[k] += slant * normal[k];
  }
  camera->SetFocalPoint(corners[0]);
  camera->SetPosition(eye);
  camera->SetViewUp(up);
}

// Two layers of a funnel, and another one behind it that its rays do not enter twice.
void AddFunnel(TileArrays& arrays, const float (&heights)[3], float wide, float widens)
{
  constexpr int cells[6][4] = { { 0, 1, 3, 7 }, { 0, 1, 5, 7 }, { 0, 2, 3, 7 }, { 0, 2, 6, 7 },
    { 0, 4, 5, 7 }, { 0, 4, 6, 7 } };
  const auto first = static_cast<int>(arrays.Points.size() / 4);
  for (int at = 0; at < 12; ++at)
  {
    const float half = wide + widens * static_cast<float>(at / 4);
    const float x = at % 2 != 0 ? half : -0.93f * half, y = at / 2 % 2 != 0 ? 1.07f * half : -half;
    arrays.Points.insert(arrays.Points.end(), { x, y, heights[at / 4], 0.0f });
    arrays.Scalars.push_back(0.08f * static_cast<float>(at));
  }
  for (int at = 0; at < 48; ++at)
  {
    arrays.Corners.push_back(first + at / 24 * 4 + cells[at / 4 % 6][at % 4]);
  }
}

// The near plane in faces of the mesh: by rounding its cut-off cells have no pixel.
void CheckNearPlane(TestChecks& checks)
{
  TileArrays arrays(1);
  arrays.Points.clear();
  arrays.Scalars.clear();
  arrays.Corners.clear();
  AddFunnel(arrays, { 0.0f, 0.3f, 0.6f }, 0.3f, 0.15f);
  AddFunnel(arrays, { -0.9f, -0.7f, -0.5f }, 0.18f, 0.03f);
  arrays.SetFunction(false, 0.1);
  arrays.SetMesh();
  for (int i = 0; i < 400; ++i)
  {
    const double eye = 1.5 + 0.00371 * i, before = eye - double(0.3f);
    arrays.LookFrom({ 0.0, 0.0, eye }, 34.0, 40, 40);
    arrays.Scene.Camera.ViewToClip = glm::perspective(0.6, 1.0, before, before + 3.0);
    arrays.Scene.EndsEarly = false;
    arrays.Scene.TrustsOrder = true;
    CHECK(arrays.Render());
    const std::vector<float> trusting = arrays.Engine.GetImage();
    arrays.Scene.TrustsOrder = false;
    CHECK(arrays.Render());
    CHECK_AT_MOST(TileArrays::LargestDifference(arrays.Engine.GetImage(), trusting), 1e-5);
  }
}

// Rounding decides which way such a face looks, and pixels lie in it.
void CheckSlivers(TestChecks& checks)
{
  const Grid grid = WithScalar(Lattice(4));
  TilesScene scene(101, 101);
  scene.SetTetrahedra(grid);
  scene.SetSmooth();
  scene.Property->SetScalarOpacityUnitDistance(0.01 * grid->GetLength());
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetParallelScale(0.3 * grid->GetLength());
  std::mt19937 random(3);
  for (int view = 0; view < 40; ++view)
  {
    LookAlongFace(camera, grid, view * 9, random, view % 2 == 0 ? 1.0 : 0.5);
    camera->SetParallelProjection(view % 4 < 2);
    scene.Renderer->ResetCameraClippingRange(grid->GetBounds());
    CheckView(checks, scene);
  }
}

void CheckScenes(TestChecks& checks)
{
  const Grid grid = WithScalar(SortMeshes::FineBars());
  TilesScene scene(90, 80);
  scene.SetTetrahedra(grid);
  scene.SetSmooth();
  scene.Property->SetScalarOpacityUnitDistance(0.05 * grid->GetLength());
  // Rays that begin in a bar, and those that a plane lets begin in one.
  for (const double distance : { 0.0, 0.1, 0.3 })
  {
    scene.LookAt(grid, { 0.9, 0.3, 0.1 }, distance + 0.01);
    CheckView(checks, scene);
    CHECK_AT_MOST(scene.TilesError("eye inside"), 1e-4);
  }
  scene.LookAt(grid, { 0.9, 0.3, 0.1 }, 1.2);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(grid->GetCenter());
  plane->SetNormal(-0.8, 0.1, 0.3);
  scene.Mapper->AddClippingPlane(plane);
  CHECK(CheckView(checks, scene) == 0.0);
  CHECK_AT_MOST(scene.TilesError("clipped"), 1e-4);
  scene.Mapper->RemoveAllClippingPlanes();
}

// Cells 200 times as wide as thick: the proof repairs pixels whose pieces seem to overlap by rounding alone.
void CheckFlat(TestChecks& checks)
{
  const Grid grid = Lattice(5);
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double p[3];
    grid->GetPoint(id, p);
    grid->GetPoints()->SetPoint(id, p[0], 0.005 * p[1], p[2]);
  }
  TilesScene scene(101, 97);
  scene.SetTetrahedra(WithScalar(grid));
  scene.SetSmooth();
  long long repaired = 0;
  for (const double unit : { 0.004, 0.02 })
  {
    scene.Property->SetScalarOpacityUnitDistance(unit * grid->GetLength());
    for (const double height : { 0.001, 0.003, 0.01, 0.1 })
    {
      scene.LookAt(grid, { 0.7, height, 0.4 }, 0.8);
      CheckView(checks, scene, 5e-5);
      CHECK_AT_MOST(scene.TilesError("flat, trusted"), 1e-4);
      scene.TrustsOrder = false;
      CHECK_AT_MOST(scene.TilesError("flat, proven"), 1e-4);
      repaired += scene.Engine.GetCounts().RepairedPixels;
      scene.TrustsOrder = true;
    }
  }
  CHECK(repaired > 0);
}

// Lists that stand from frame to frame keep what is known of them; orders from elsewhere are not trusted.
void CheckFrames(TestChecks& checks)
{
  const Grid grid = WithScalar(Lattice(16));
  TilesScene scene(200, 190);
  scene.SetTetrahedra(grid);
  scene.SetSmooth();
  scene.LookAt(grid, { 0.3, 0.5, 0.7 }, 1.2);
  const double share = CheckView(checks, scene);
  CHECK(share > 0.3);
  scene.Property->SetScalarOpacityUnitDistance(0.01 * grid->GetLength());
  CHECK(CheckView(checks, scene) > 0.9 * share);
  scene.BackToFront.resize(grid->GetNumberOfCells());
  for (std::size_t i = 0; i < scene.BackToFront.size(); ++i)
  {
    scene.BackToFront[i] = static_cast<vtkIdType>(i);
  }
  CHECK(CheckView(checks, scene) == 0.0);
}
}

int TestTilesTrust(int, char*[])
{
  TestChecks checks;
  CheckMeshes(checks);
  CheckOverlap(checks);
  CheckFolded(checks);
  CheckDoubt(checks);
  CheckSlivers(checks);
  CheckFlat(checks);
  CheckNearPlane(checks);
  CheckScenes(checks);
  CheckFrames(checks);
  return checks.Result();
}
