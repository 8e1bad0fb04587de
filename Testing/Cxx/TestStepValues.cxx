// Cell scalars that lie exactly on a step of the functions have VTK's value there, whichever side
// that is: below or above, its own, of opacity and colour apart.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkBarycentricShellMapper.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"

namespace
{
// None of them, and no share of the range that they span, is a float. Two are middles of nodes.
const std::vector<double> Nodes = { 0.1, 0.1 + 0.5 * (0.5 - 0.1), 0.7, 0.6 + 0.5 * (1.6 - 0.6),
  1.7 };

void AddCellScalars(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("cells");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    values->InsertNextValue(Nodes[static_cast<std::size_t>(cell) % Nodes.size()]);
  }
  grid->GetCellData()->AddArray(values);
}

void AddOpacity(TestScene& scene, double scalar, double opacity, double sharpness = 0.0)
{
  scene.Opacity->AddPoint(scalar, opacity, 0.5, sharpness);
}

void AddColor(TestScene& scene, double scalar, double red, double blue, double sharpness = 0.0)
{
  scene.Color->AddRGBPoint(scalar, red, 0.5, blue, 0.5, sharpness);
}

void Clear(TestScene& scene)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AllowDuplicateScalarsOn();
  scene.Opacity->ClampingOn();
  scene.Color->RemoveAllPoints();
  scene.Color->AllowDuplicateScalarsOn();
  scene.Color->SetColorSpaceToRGB();
  scene.Color->ClampingOn();
}

// At the second to the fourth scalar two nodes each, and ramps between.
void StepOpacity(TestScene& scene)
{
  AddOpacity(scene, Nodes[0], 0.2);
  for (int i = 1; i < 4; ++i)
  {
    AddOpacity(scene, Nodes[i], 0.1 * i);
    AddOpacity(scene, Nodes[i], 0.9 - 0.1 * i);
  }
  AddOpacity(scene, Nodes[4], 0.5);
}

void StepColors(TestScene& scene)
{
  AddColor(scene, Nodes[0], 0.1, 0.9);
  for (int i = 1; i < 4; ++i)
  {
    AddColor(scene, Nodes[i], 0.2 * i, 0.3);
    AddColor(scene, Nodes[i], 0.9 - 0.1 * i, 0.8);
  }
  AddColor(scene, Nodes[4], 0.7, 0.2);
}

void RampColors(TestScene& scene)
{
  AddColor(scene, Nodes[0], 0.1, 0.9);
  AddColor(scene, Nodes[4], 0.9, 0.2);
}

void RampOpacity(TestScene& scene)
{
  AddOpacity(scene, Nodes[0], 0.2);
  AddOpacity(scene, Nodes[4], 0.8);
}

// Halfway between nodes whose middles are the second and the fourth scalar.
void StepMidpoints(TestScene& scene)
{
  AddOpacity(scene, Nodes[0], 0.1, 1.0);
  AddOpacity(scene, 0.5, 0.8);
  AddOpacity(scene, 0.6, 0.2, 1.0);
  AddOpacity(scene, 1.6, 0.7);
  AddColor(scene, Nodes[0], 0.1, 0.9, 1.0);
  AddColor(scene, 0.5, 0.9, 0.1);
  AddColor(scene, 0.6, 0.2, 0.3, 1.0);
  AddColor(scene, 1.6, 0.9, 0.8);
}

// Nothing beyond the nodes, of which the ends are scalars within the range.
void StepEnds(TestScene& scene)
{
  AddOpacity(scene, Nodes[1], 0.3);
  AddOpacity(scene, Nodes[3], 0.8);
  AddColor(scene, Nodes[1], 0.2, 0.9);
  AddColor(scene, Nodes[3], 0.9, 0.2);
  scene.Opacity->ClampingOff();
  scene.Color->ClampingOff();
}

struct Function
{
  std::string Name;
  std::function<void(TestScene&)> Add;
};

const std::vector<Function> Functions = {
  { "opacity",
    [](TestScene& scene)
    {
      StepOpacity(scene);
      RampColors(scene);
    } },
  { "colours",
    [](TestScene& scene)
    {
      RampOpacity(scene);
      StepColors(scene);
    } },
  { "both",
    [](TestScene& scene)
    {
      StepOpacity(scene);
      StepColors(scene);
    } },
  { "midpoints", StepMidpoints },
  { "ends", StepEnds },
  { "ends at the range's",
    [](TestScene& scene)
    {
      RampOpacity(scene);
      RampColors(scene);
      scene.Opacity->ClampingOff();
      scene.Color->ClampingOff();
    } },
  { "colour space",
    [](TestScene& scene)
    {
      RampOpacity(scene);
      StepColors(scene);
      scene.Color->SetColorSpaceToStep();
    } },
};

void TakeCellScalars(TestScene& scene)
{
  scene.Mapper->SetScalarModeToUseCellFieldData();
  scene.Mapper->SelectScalarArray("cells");
  scene.Oracle->SetCellScalars(true);
  scene.Oracle->SetArrayName("cells");
}

void CheckTetrahedra(TestChecks& checks, TestScene& scene, const std::string& name)
{
  auto grid = TestMeshes::SixTetrahedra();
  AddCellScalars(grid);
  scene.SetGrid(grid);
  TakeCellScalars(scene);
  // Near, and from so far that the eye's distance leaves a float few digits.
  for (const double distance : { 1.0, 1000.0 })
  {
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    scene.LookFrom(0.5 * distance, 0.8 * distance, 2.2 * distance);
    camera->SetClippingRange(distance, 4.0 * distance);
    camera->SetViewAngle(30.0 / distance);
    for (const Function& function : Functions)
    {
      Clear(scene);
      function.Add(scene);
      const std::string what = name + ", " + function.Name + ", " + std::to_string(distance);
      const double error = scene.MaximumError(what);
      checks.Check(error >= 0.0 && error <= 1e-4, what.c_str(), __LINE__, std::to_string(error));
    }
  }
}

void CheckPolyhedra(TestChecks& checks, const PolyhedraMappers::Entry& mapper, int engine)
{
  PolyhedraScene scene(mapper.Make(), 64, 64);
  scene.Mapper->SetEngine(engine);
  auto grid = PolyhedraMeshes::Hexahedra(2);
  AddCellScalars(grid);
  scene.SetMesh(grid);
  TakeCellScalars(scene);
  scene.SetView(0);
  for (const Function& function : Functions)
  {
    Clear(scene);
    function.Add(scene);
    const std::string what = mapper.Name + " " + std::to_string(engine) + ", " + function.Name;
    const PolyhedraScene::Errors errors = scene.CompareWithOracle(what);
    checks.Check(errors.Compared >= 0.0 && errors.Compared <= 1e-4, what.c_str(), __LINE__,
      std::to_string(errors.Compared));
  }
}

void CheckShells(TestChecks& checks)
{
  vtkNew<vtkBarycentricShellMapper> mapper;
  mapper->SetMethodToCellProjection();
  TestScene scene(mapper, 64, 64);
  CheckTetrahedra(checks, scene, "shells' cells");
}
}

int TestStepValues(int, char*[])
{
  TestChecks checks;
  for (const int engine : { vtkConvexCellMapper::RASTER, vtkConvexCellMapper::TILES })
  {
    TestScene scene(64, 64);
    scene.Mapper->SetEngine(engine);
    CheckTetrahedra(checks, scene, engine == vtkConvexCellMapper::TILES ? "Tiles" : "Raster");
    for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
    {
      CheckPolyhedra(checks, mapper, engine);
    }
  }
  CheckShells(checks);
  return checks.Result();
}
