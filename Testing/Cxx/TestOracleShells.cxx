/**
 * Cell scalars: nested cubical shells of constant extinction and colour, so that a ray's depth is a
 * sum of differences of box chords, and the central ray's colour seven layers by hand.
 */

#include "TestOracleScene.h"

namespace
{
const int Shells = 4; // a grid of 7 blocks: the core and three shells
const double Extinctions[Shells] = { 3.0, 0.7, 0.0, 0.4 };

/** The shell of a position, 0 at the core; shell k ends at (2 k + 1) / 7 from the centre. */
int GetShell(const double p[3])
{
  const double distance = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  return static_cast<int>(std::ceil((7.0 * distance - 1.0) / 2.0 - 1e-9));
}

vtkSmartPointer<vtkUnstructuredGrid> BuildShells(int cellType)
{
  TestOracleBox box;
  box.CellType = cellType;
  box.Blocks = { 7, 7, 7 };
  vtkSmartPointer<vtkUnstructuredGrid> grid = box.Build();
  vtkNew<vtkDoubleArray> shells;
  shells->SetName("shell");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    grid->GetCellBounds(cell, bounds);
    const double center[3] = { (bounds[0] + bounds[1]) / 2.0, (bounds[2] + bounds[3]) / 2.0,
      (bounds[4] + bounds[5]) / 2.0 };
    shells->InsertNextValue(GetShell(center));
  }
  grid->GetCellData()->SetScalars(shells);
  return grid;
}

void SetUp(TestOracleScene& scene)
{
  scene.Opacity->RemoveAllPoints();
  scene.Color->RemoveAllPoints();
  for (int shell = 0; shell < Shells; ++shell)
  {
    scene.Opacity->AddPoint(shell, Extinctions[shell] / 10.0);
    scene.Color->AddRGBPoint(shell, shell / 3.0, 1.0 - shell / 3.0, 0.5);
  }
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(0.1);
  scene.Oracle->SetCellScalars(true);
}

void CheckAlpha(TestOracleChecks& checks, int cellType)
{
  TestOracleScene scene;
  SetUp(scene);
  CHECK_TRUE(checks, scene.Draw(BuildShells(cellType)));
  for (int row = 0; row < scene.Height; ++row)
  {
    for (int column = 0; column < scene.Width; ++column)
    {
      double depth = 0.0, inner = 0.0;
      for (int shell = 0; shell < Shells; ++shell)
      {
        const double half = (2.0 * shell + 1.0) / 7.0;
        const auto chord =
          scene.GetInterval(column, row, { -half, half, -half, half, -half, half });
        const double length = std::max(0.0, chord[1] - chord[0]);
        depth += Extinctions[shell] * (length - inner);
        inner = length;
      }
      CHECK_NEAR(checks, scene.GetValue(column, row, 3), -std::expm1(-depth), 1e-10);
    }
  }
}

/** The axis meets the shells 3 2 1 0 1 2 3, each over 2/7. */
void CheckCentralRay(TestOracleChecks& checks, int cellType)
{
  TestOracleScene scene;
  SetUp(scene);
  scene.Camera->SetPosition(0.01, 0.02, 5.0);
  scene.Camera->SetFocalPoint(0.01, 0.02, 0.0);
  scene.Oracle->SetSize(1, 1);
  CHECK_TRUE(checks, scene.Draw(BuildShells(cellType)));
  double red = 0.0, transmittance = 1.0;
  for (int shell : { 3, 2, 1, 0, 1, 2, 3 })
  {
    const double alpha = 1.0 - std::exp(-Extinctions[shell] * 2.0 / 7.0);
    red += transmittance * alpha * shell / 3.0;
    transmittance *= 1.0 - alpha;
  }
  CHECK_NEAR(checks, scene.GetValue(0, 0, 0), red, 1e-10);
  CHECK_NEAR(checks, scene.GetValue(0, 0, 1), 1.0 - transmittance - red, 1e-10);
  CHECK_NEAR(checks, scene.GetValue(0, 0, 3), 1.0 - transmittance, 1e-10);
  scene.Oracle->SetBlendMode(vtkCellProjectionOracle::MINIMUM_INTENSITY_BLEND);
  CHECK_TRUE(checks, scene.Oracle->Update());
  CHECK_NEAR(checks, scene.GetValue(0, 0, 3), Extinctions[0] / 10.0, 1e-12);
}
}

int TestOracleShells(int, char*[])
{
  TestOracleChecks checks(__FILE__);
  for (int cellType : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    CheckAlpha(checks, cellType);
    CheckCentralRay(checks, cellType);
  }
  return checks.GetResult();
}
