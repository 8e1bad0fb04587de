// Iso-surfaces of the squared radius over a lattice: depth in the window is that of the contour of
// the same tetrahedra within 1e-5 of the mesh's size, and in the same pixels; normals within 2
// degrees of the sphere's; several translucent ones add up in their order; a gradient
// opacity takes its part.

#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"
#include "vtkConvexCells.h"

#include "vtkCellLocator.h"
#include "vtkContourFilter.h"
#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkPolyData.h"

#include <cmath>

namespace
{
constexpr int Size = 64;
// At this scale no pixel has its centre on the silhouette.
constexpr double Near = 1.2, Far = 3.2, Scale = 0.61, Eye = 2.0;

double SquaredRadius(const double p[3])
{
  return p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
}

TestMeshes::Grid Lattice(int cells)
{
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int counts[3] = { cells, cells, cells };
  auto grid = TestMeshes::Slab(size, counts);
  TestMeshes::SetField(grid, SquaredRadius);
  return grid;
}

/// A parallel view down the third axis.
class IsoScene : public TestScene
{
public:
  IsoScene()
    : TestScene(vtkNew<vtkBarycentricShellMapper>(), Size, Size)
  {
    this->Mapper->SetBlendModeToIsoSurface();
    this->LookFrom(0.0, 0.0, Eye);
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Renderer->GetActiveCamera()->SetParallelScale(Scale);
    this->Renderer->GetActiveCamera()->SetClippingRange(Near, Far);
    this->SetConstant(1.0);
    this->SetValues({ 0.16 });
  }
  void SetValues(const std::vector<double>& values)
  {
    this->Property->GetIsoSurfaceValues()->SetNumberOfContours(static_cast<int>(values.size()));
    for (size_t i = 0; i < values.size(); ++i)
    {
      this->Property->GetIsoSurfaceValues()->SetValue(static_cast<int>(i), values[i]);
    }
  }
};

// World coordinates of a pixel's centre.
double PlaceOf(int pixel)
{
  return Scale * (2.0 * (pixel + 0.5) / Size - 1.0);
}

/// Rays down the third axis against the contour of the same tetrahedra.
class ContourRays
{
public:
  explicit ContourRays(vtkUnstructuredGridBase* grid)
  {
    vtkNew<vtkConvexCells> cut;
    cut->SetInputData(grid);
    cut->TetrahedraOnlyOn();
    vtkNew<vtkContourFilter> contour;
    contour->SetInputConnection(cut->GetOutputPort());
    contour->SetValue(0, 0.16);
    contour->Update();
    this->Locator->SetDataSet(contour->GetOutput());
    this->Locator->BuildLocator();
  }
  bool Hits(double x, double y, double& z)
  {
    const double start[3] = { x, y, 1.0 };
    const double end[3] = { x, y, -1.0 };
    double t, point[3], coordinates[3];
    int part;
    const bool hits =
      this->Locator->IntersectWithLine(start, end, 1e-12, t, point, coordinates, part) != 0;
    z = point[2];
    return hits;
  }

private:
  vtkNew<vtkCellLocator> Locator;
};

void CheckDepth(TestChecks& checks, IsoScene& scene)
{
  scene.Render();
  vtkNew<vtkFloatArray> depths;
  scene.Window->GetZbufferData(0, 0, Size - 1, Size - 1, depths);
  ContourRays rays(scene.Mapper->GetInput());
  int covered = 0, silhouettes = 0;
  double largest = 0.0;
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const double x = PlaceOf(pixel % Size), y = PlaceOf(pixel / Size);
    double z;
    const bool isHit = rays.Hits(x, y, z);
    const double depth = depths->GetValue(pixel);
    silhouettes += isHit != (depth < 1.0) ? 1 : 0;
    if (isHit && depth < 1.0)
    {
      ++covered;
      largest = std::max(largest, std::abs(Near + depth * (Far - Near) - (Eye - z)));
    }
  }
  std::cout << covered << " pixels, largest error of depth " << largest << ", " << silhouettes
            << " pixels differ at the silhouette\n";
  CHECK_AT_MOST(1000, covered);
  CHECK_AT_MOST(largest, 1e-5);
  CHECK(silhouettes == 0);
}

// Three directional lights, one after the other: each leaves a component of the normal.
void CheckNormals(TestChecks& checks, IsoScene& scene)
{
  scene.Property->ShadeOn();
  scene.Property->SetAmbient(0.0);
  scene.Property->SetDiffuse(1.0);
  scene.Property->SetSpecular(0.0);
  scene.Renderer->AutomaticLightCreationOff();
  scene.Renderer->RemoveAllLights();
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetFocalPoint(0.0, 0.0, 0.0);
  scene.Renderer->AddLight(light);
  std::vector<std::array<double, 3>> normals(Size * Size);
  for (int axis = 0; axis < 3; ++axis)
  {
    light->SetPosition(axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0);
    scene.Render();
    for (int pixel = 0; pixel < Size * Size; ++pixel)
    {
      normals[pixel][axis] = scene.Pixel(pixel % Size, pixel / Size)[0];
    }
  }
  double least = 1.0, longest = 0.0, shortest = 2.0;
  int compared = 0;
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const double x = PlaceOf(pixel % Size), y = PlaceOf(pixel / Size);
    const double square = 0.16 - x * x - y * y;
    if (square > 0.001 && scene.Pixel(pixel % Size, pixel / Size)[3] > 0.5)
    {
      const std::array<double, 3>& n = normals[pixel];
      const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      const double along = std::abs(x) * n[0] + std::abs(y) * n[1] + std::sqrt(square) * n[2];
      least = std::min(least, along / (0.4 * length));
      longest = std::max(longest, length);
      shortest = std::min(shortest, length);
      ++compared;
    }
  }
  const double degrees = std::acos(std::min(least, 1.0)) * 180.0 / std::acos(-1.0);
  std::cout << "largest error of a normal " << degrees << " degrees, lengths " << shortest
            << " to " << longest << "\n";
  CHECK_AT_MOST(1000, compared);
  CHECK_AT_MOST(degrees, 2.0);
  CHECK_AT_MOST(longest, 1.001);
  CHECK_AT_MOST(0.999, shortest);
  scene.Property->ShadeOff();
}

// A ray through the middle meets each of two spheres twice.
void CheckTranslucent(TestChecks& checks, IsoScene& scene)
{
  scene.SetValues({ 0.16, 0.04 });
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(0.04, 1.0, 0.0, 0.0);
  scene.Color->AddRGBPoint(0.16, 0.0, 1.0, 0.0);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.04, 0.5);
  scene.Opacity->AddPoint(0.16, 0.25);
  scene.Render();
  const std::array<double, 4> pixel = scene.CenterPixel();
  const double red = 0.75 * 0.5 * (1.0 + 0.5);
  const double green = 0.25 + 0.75 * 0.5 * 0.5 * 0.25;
  CHECK_NEAR(pixel[0], red, 1e-4);
  CHECK_NEAR(pixel[1], green, 1e-4);
  CHECK_NEAR(pixel[3], red + green, 1e-4);
  // Edges of faces and lattice planes show a surface no second time.
  int twice = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const double square = PlaceOf(x) * PlaceOf(x) + PlaceOf(y) * PlaceOf(y);
      const double alpha = scene.Pixel(x, y)[3];
      twice += square > 0.05 && alpha > 1.0 - 0.75 * 0.75 + 1e-4 ? 1 : 0;
    }
  }
  CHECK(twice == 0);
}

// A gradient of length 0.8 all over the sphere: half of what a function up to 1.6 gives.
void CheckGradientOpacity(TestChecks& checks, IsoScene& scene)
{
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.SetValues({ 0.16 });
  scene.SetConstant(1.0);
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(1.6, 1.0);
  scene.Property->SetGradientOpacity(function);
  for (const bool shaded : { false, true })
  {
    scene.Property->SetShade(shaded ? 1 : 0);
    scene.Render();
    CHECK_NEAR(scene.CenterPixel()[3], 0.75, 2e-2);
  }
  scene.Property->ShadeOff();
  scene.Property->DisableGradientOpacityOn();
  scene.Render();
  CHECK(scene.CenterPixel()[3] == 1.0);
  CHECK(messages->Count() == 0);
}

void CheckMessages(TestChecks& checks, IsoScene& scene)
{
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.SetValues({});
  scene.Render();
  scene.Render();
  CHECK(messages->Count() == 1 && messages->CountOf("no iso-surface values") == 1);
  CHECK(scene.CenterPixel()[3] == 0.0);
  // The same mapper draws volumes again, with opacities per length.
  scene.Mapper->SetBlendModeToComposite();
  scene.SetConstant(1.0);
  scene.Render();
  CHECK_NEAR(scene.CenterPixel()[3], 1.0 - std::exp(-1.0), 1e-3);
}
}

int TestIsoSurfaces(int, char*[])
{
  TestChecks checks;
  IsoScene scene;
  scene.SetGrid(Lattice(40));
  CheckDepth(checks, scene);
  CheckNormals(checks, scene);
  CheckTranslucent(checks, scene);
  CheckGradientOpacity(checks, scene);
  CheckMessages(checks, scene);
  return checks.Result();
}
