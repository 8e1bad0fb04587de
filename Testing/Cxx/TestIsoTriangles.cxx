// The triangles of opaque iso-surfaces: a plane's have its area and no crack, a face on the value
// counts once, what is not a number is left out, each has a vertex of its own number. Drawn, they give
// the image of the surfaces found ray by ray in the cells, straight into the window as through the
// captured image.

#include "OpaquePlane.h"
#include "IsoTriangles.h"
#include "NumberedTriangles.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"
#include "vtkConvexCells.h"

#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

namespace
{
constexpr int Size = 64;

/// A mesh as IsoTriangles takes it.
struct Mesh
{
  std::vector<int> Corners;
  std::vector<float> Points;
  std::vector<float> Scalars;
};

Mesh TakeMesh(vtkUnstructuredGrid* input, const std::function<double(const double*)>& field)
{
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(input);
  cut->TetrahedraOnlyOn();
  cut->Update();
  vtkUnstructuredGrid* grid = cut->GetOutput();
  Mesh mesh;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    std::sort(ids->begin(), ids->end());
    mesh.Corners.insert(mesh.Corners.end(), ids->begin(), ids->end());
  }
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    const double* p = grid->GetPoint(id);
    for (int i = 0; i < 3; ++i)
    {
      mesh.Points.push_back(static_cast<float>(p[i]));
    }
    mesh.Points.push_back(0.0f);
    mesh.Scalars.push_back(static_cast<float>(field(p)));
  }
  return mesh;
}

double AreaOf(const IsoTriangles& surface, size_t triangle)
{
  double p[3][3];
  for (int i = 0; i < 9; ++i)
  {
    const int vertex = surface.Triangles[3 * triangle + i / 3];
    p[i / 3][i % 3] = surface.Vertices[4 * static_cast<size_t>(vertex) + i % 3];
  }
  double square = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double part =
      (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
    square += part * part;
  }
  return 0.5 * std::sqrt(square);
}

double AreaOf(const IsoTriangles& surface)
{
  double area = 0.0;
  for (size_t triangle = 0; triangle < surface.Triangles.size() / 3; ++triangle)
  {
    area += AreaOf(surface, triangle);
  }
  return area;
}

// Edges that other than two triangles share, the mesh's boundary apart.
int CountOpenEdges(const IsoTriangles& surface)
{
  std::map<std::pair<int, int>, int> edges;
  for (size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    const int a = surface.Triangles[i];
    const int b = surface.Triangles[i % 3 == 2 ? i - 2 : i + 1];
    ++edges[{ std::min(a, b), std::max(a, b) }];
  }
  int open = 0;
  for (const auto& edge : edges)
  {
    open += edge.second == 2 ? 0 : 1;
  }
  return open;
}

void CheckPlane(TestChecks& checks)
{
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int counts[3] = { 5, 4, 3 };
  Mesh mesh = TakeMesh(TestMeshes::Slab(size, counts), [](const double* p) { return p[2]; });
  IsoTriangles surface;
  surface.Cut(mesh.Corners, mesh.Scalars, { 0.05f, -0.21f });
  surface.Move(mesh.Corners, mesh.Points);
  CHECK(surface.Surfaces.size() == 2 && surface.Surfaces[0].Value == -0.21f);
  CHECK_NEAR(AreaOf(surface), 2.0, 1e-6);
  // The plane of a layer of points is there once, also where cells lie on both sides.
  const std::set<float> layers(mesh.Scalars.begin(), mesh.Scalars.end());
  CHECK(layers.size() == 4);
  for (const float layer : layers)
  {
    surface.Cut(mesh.Corners, mesh.Scalars, { layer });
    surface.Move(mesh.Corners, mesh.Points);
    CHECK_NEAR(AreaOf(surface), 1.0, 1e-6);
    CHECK(surface.Triangles.size() == 3 * 2 * 5 * 4);
    CHECK(surface.Vertices.size() == 4 * 6 * 5);
  }
  mesh.Scalars[7] = std::numeric_limits<float>::quiet_NaN();
  surface.Cut(mesh.Corners, mesh.Scalars, { 0.05f });
  CHECK(surface.NumberOfInvalidCells > 0);
  const int used = surface.FindPoints(mesh.Scalars.size()).front();
  mesh.Points[4 * static_cast<size_t>(used)] = std::numeric_limits<float>::infinity();
  surface.Move(mesh.Corners, mesh.Points);
  CHECK(surface.NumberOfLostCells > 0);
  CHECK(std::isfinite(AreaOf(surface)));
}

// The same triangles, turned at most; the last vertex of each has its number.
void CheckNumbers(TestChecks& checks, const IsoTriangles& surface)
{
  const size_t vertices = surface.Vertices.size() / 4;
  const NumberedTriangles numbered(surface.Triangles, vertices);
  CHECK(numbered.Indices.size() == surface.Triangles.size());
  int wrong = 0;
  std::set<int> used;
  for (size_t i = 0; i < surface.Triangles.size(); i += 3)
  {
    const int* ids = &numbered.Indices[i];
    const std::array<int, 3> corners{ numbered.Corners[4 * ids[0] + 2],
      numbered.Corners[4 * ids[1] + 2], numbered.Corners[4 * ids[2] + 2] };
    wrong += ids[2] == static_cast<int>(i / 3) ? 0 : 1;
    wrong += std::equal(corners.begin(), corners.end(), &numbered.Corners[4 * i / 3]) ? 0 : 1;
    const auto turned =
      std::search_n(corners.begin(), corners.end(), 1, surface.Triangles[i]) - corners.begin();
    for (size_t k = 0; k < 3; ++k)
    {
      wrong += corners[(turned + k) % 3] == surface.Triangles[i + k] ? 0 : 1;
    }
    used.insert(corners.begin(), corners.end());
  }
  CHECK(wrong == 0);
  CHECK(used.size() == vertices);
  // There are half as many vertices as triangles: few numbers beyond those go to waste.
  CHECK_AT_MOST(numbered.Corners.size() / 4, surface.Triangles.size() / 3 + vertices / 20);
}

void CheckClosed(TestChecks& checks)
{
  const Mesh mesh = TakeMesh(TestMeshes::JitteredCube(8),
    [](const double* p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; });
  IsoTriangles surface;
  surface.Cut(mesh.Corners, mesh.Scalars, { 0.16f });
  surface.Move(mesh.Corners, mesh.Points);
  CHECK(surface.Triangles.size() > 600);
  CHECK(CountOpenEdges(surface) == 0);
  CheckNumbers(checks, surface);
  CHECK_NEAR(AreaOf(surface), 4.0 * std::acos(-1.0) * 0.16, 0.1);
  const std::vector<int> points = surface.FindPoints(mesh.Scalars.size());
  CHECK(std::is_sorted(points.begin(), points.end()));
  CHECK(!points.empty() && points.size() < mesh.Scalars.size());
}

/// A shaded sphere with a dent; opacities that differ by 1e-4 choose the way it is drawn.
class SurfaceScene : public TestScene
{
public:
  SurfaceScene()
    : TestScene(vtkNew<vtkBarycentricShellMapper>(), Size, Size)
  {
    auto grid = TestMeshes::JitteredCube(8);
    TestMeshes::SetField(grid, Dent);
    this->SetGrid(grid);
    this->Mapper->SetBlendModeToIsoSurface();
    this->Property->ShadeOn();
    this->Property->GetIsoSurfaceValues()->SetValue(0, 0.16);
    this->Property->GetIsoSurfaceValues()->SetValue(1, 0.09);
    this->LookFrom(0.8, 0.7, 1.6);
  }
  static double Dent(const double* p)
  {
    return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + 0.5 * std::max(p[2], 0.0) * p[0];
  }
  int CountDrawn() { return this->Mapper->GetLastStatistics()->GetValueByName(0, "CellsDrawn").ToInt(); }
  /// Pixels where triangles differ from what rays find in the cells.
  int CountDifferences(TestChecks& checks, const std::string& name)
  {
    this->SetConstant(1.0);
    this->Render();
    auto triangles = this->CopyCaptured();
    int covered = 0;
    for (int pixel = 0; pixel < Size * Size; ++pixel)
    {
      covered += triangles->GetPointData()->GetScalars()->GetComponent(pixel, 3) > 0.5 ? 1 : 0;
    }
    this->SetConstant(0.9999);
    this->Render();
    const int different = CountDifferent(triangles, this->Mapper->GetCapturedImage(), 3e-3);
    std::cout << name << ": " << covered << " pixels, " << different << " differ\n";
    checks.Check(covered > 400, name.c_str(), __LINE__, std::to_string(covered));
    // Silhouettes run within a 256th of a pixel of some centres.
    checks.Check(different <= 3, name.c_str(), __LINE__, std::to_string(different));
    return different;
  }
};

void CheckImages(TestChecks& checks)
{
  SurfaceScene scene;
  scene.CountDifferences(checks, "perspective");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.5);
  scene.CountDifferences(checks, "parallel");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  vtkNew<vtkPlaneCollection> planes;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.05, 0.0, 0.1);
  plane->SetNormal(-1.0, -0.4, -0.6);
  planes->AddItem(plane);
  scene.Mapper->SetClippingPlanes(planes);
  scene.CountDifferences(checks, "clipped");
  scene.Mapper->SetClippingPlanes(static_cast<vtkPlaneCollection*>(nullptr));
  scene.Renderer->GetActiveCamera()->SetClippingRange(1.6, 2.05);
  scene.CountDifferences(checks, "near and far plane through it");
  scene.LookFrom(0.1, 0.02, 0.05);
  scene.Renderer->GetActiveCamera()->SetClippingRange(1e-3, 10.0);
  scene.CountDifferences(checks, "from inside");
  scene.LookFrom(0.8, 0.7, 1.6);
  scene.Volume->SetScale(1.0, 1.4, 0.7);
  scene.Volume->SetPosition(1e6, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(1e6, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->SetPosition(1e6 + 0.8, 0.7, 1.6);
  scene.CountDifferences(checks, "scaled and far away");
}

// Points, scalars and values that change: as from a fresh mapper.
void CheckChanges(TestChecks& checks)
{
  SurfaceScene scene;
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(scene.Mapper->GetInput());
  scene.SetConstant(1.0);
  scene.Render();
  const int before = scene.CountDrawn();
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double p[3];
    grid->GetPoints()->GetPoint(id, p);
    grid->GetPoints()->SetPoint(id, p[0] + 0.2 * p[1] * p[1], p[1], 0.8 * p[2] + 0.1 * p[0]);
  }
  grid->GetPoints()->Modified();
  scene.CountDifferences(checks, "moved points");
  scene.SetConstant(1.0);
  scene.Render();
  CHECK(scene.CountDrawn() == before);
  TestMeshes::SetField(grid, [](const double* p) { return 0.14 + 0.2 * p[0] + 0.05 * p[1]; });
  scene.CountDifferences(checks, "new scalars");
  scene.Property->GetIsoSurfaceValues()->SetValue(1, 0.11);
  scene.CountDifferences(checks, "new value");
  scene.Property->ShadeOff();
  scene.CountDifferences(checks, "not shaded");
}

vtkSmartPointer<vtkUnsignedCharArray> ReadWindow(TestScene& scene)
{
  auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  const int* size = scene.Window->GetSize();
  scene.Window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  return pixels;
}

int CountDifferent(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  int different = 0;
  for (vtkIdType id = 0; id < a->GetNumberOfTuples(); ++id)
  {
    double most = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      most = std::max(most, std::abs(a->GetComponent(id, i) - b->GetComponent(id, i)));
    }
    different += most > 1.0 ? 1 : 0;
  }
  return different;
}

// A plane that cuts the surface in half, and a viewport that does not start at the window's corner.
void CheckWindow(TestChecks& checks)
{
  SurfaceScene scene;
  OpaquePlane::Add(scene, 0.15, 0.15);
  scene.Window->SetSize(2 * Size + 30, Size + 20);
  scene.Renderer->SetViewport(0.3, 0.2, 0.9, 0.9);
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.5, 4.0);
  scene.SetConstant(1.0);
  std::vector<vtkSmartPointer<vtkUnsignedCharArray>> pictures;
  std::vector<vtkSmartPointer<vtkFloatArray>> depths;
  for (const bool captures : { true, false })
  {
    scene.Mapper->SetCaptureImage(captures);
    scene.Render();
    pictures.push_back(ReadWindow(scene));
    depths.push_back(vtkSmartPointer<vtkFloatArray>::New());
    scene.Window->GetZbufferData(0, 0, 2 * Size + 29, Size + 19, depths.back());
    CHECK((scene.Mapper->GetCapturedImage() != nullptr) == captures);
  }
  CHECK_AT_MOST(CountDifferent(pictures[0], pictures[1]), 2);
  int other = 0;
  for (vtkIdType id = 0; id < depths[0]->GetNumberOfValues(); ++id)
  {
    other += std::abs(depths[0]->GetValue(id) - depths[1]->GetValue(id)) > 1e-6 ? 1 : 0;
  }
  CHECK_AT_MOST(other, 2);
  scene.Volume->VisibilityOff();
  scene.Render();
  CHECK(CountDifferent(pictures[1], ReadWindow(scene)) > 300);
}
}

int TestIsoTriangles(int, char*[])
{
  TestChecks checks;
  CheckPlane(checks);
  CheckClosed(checks);
  CheckImages(checks);
  CheckChanges(checks);
  CheckWindow(checks);
  return checks.Result();
}
