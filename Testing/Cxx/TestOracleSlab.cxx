/**
 * Constant extinction in a box: alpha = 1 - exp(-tau L), C = kappa alpha, with the L of every pixel
 * worked out from the box; all cell types, both projections, thin boxes, actor matrices, cut rays.
 */

#include "TestOracleScene.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

namespace
{
const int CellTypes[] = { VTK_TETRA, VTK_HEXAHEDRON, VTK_VOXEL, VTK_WEDGE, VTK_PYRAMID,
  VTK_POLYHEDRON };

using Cut = std::function<void(int column, int row, std::array<double, 2>& interval)>;

void NoCut(int, int, std::array<double, 2>&) {}

/** Every pixel of the scene against the closed form; `cut` shortens the expected interval. */
void CheckBox(TestOracleChecks& checks, TestOracleScene& scene, const TestOracleBox& box,
  double extinction, double tolerance, const Cut& cut = NoCut)
{
  scene.SetExtinction(extinction);
  CHECK_TRUE(checks, scene.Draw(box.Build()));
  int covered = 0;
  for (int row = 0; row < scene.Height; ++row)
  {
    for (int column = 0; column < scene.Width; ++column)
    {
      std::array<double, 2> interval = scene.GetInterval(column, row, box.Bounds);
      cut(column, row, interval);
      const double length = std::max(0.0, interval[1] - interval[0]);
      const double alpha = -std::expm1(-extinction * length);
      covered += alpha > 0.0;
      CHECK_NEAR(checks, scene.GetValue(column, row, 3), alpha, tolerance);
      for (int channel = 0; channel < 3; ++channel)
      {
        CHECK_NEAR(
          checks, scene.GetValue(column, row, channel), alpha * scene.Kappa[channel], tolerance);
      }
    }
  }
  CHECK_TRUE(checks, covered > 20);
}

void CheckCellTypes(TestOracleChecks& checks)
{
  for (int cellType : CellTypes)
  {
    for (bool parallel : { false, true })
    {
      TestOracleScene scene;
      scene.Camera->SetParallelProjection(parallel);
      TestOracleBox box;
      box.CellType = cellType;
      CheckBox(checks, scene, box, 0.8, 1e-9);
      // Seen along the lattice: rays run inside faces and edges, and no cell may count twice.
      box.Blocks = { 6, 6, 3 };
      scene.Camera->SetPosition(0.0, 0.0, 5.0);
      scene.Camera->SetFocalPoint(0.0, 0.0, 0.0);
      scene.Camera->SetParallelScale(1.5);
      CheckBox(checks, scene, box, 0.8, 1e-9);
    }
  }
}

/** A thin box keeps its opacity: the length is 1e-6 of the distances that it is the difference of.
 */
void CheckThinBoxes(TestOracleChecks& checks)
{
  for (int cellType : CellTypes)
  {
    for (double thickness : { 1e-2, 1e-4, 1e-6 })
    {
      TestOracleScene scene;
      TestOracleBox box;
      box.CellType = cellType;
      box.Bounds = { -1.0, 1.0, -1.0, 1.0, 0.0, thickness };
      CheckBox(checks, scene, box, 2.0 / thickness, std::max(1e-9, 3e-14 / thickness));
    }
  }
}

/** One cell of optical depth 800: all of its light comes from its first thousandth. */
void CheckOpaqueBox(TestOracleChecks& checks)
{
  for (int cellType : CellTypes)
  {
    TestOracleScene scene;
    TestOracleBox box;
    box.CellType = cellType;
    box.Blocks = { 1, 1, 1 };
    CheckBox(checks, scene, box, 400.0, 1e-9);
  }
}

void CheckActorMatrices(TestOracleChecks& checks)
{
  const double scales[][3] = { { 0.1, 0.1, 0.1 }, { 3.0, 3.0, 3.0 }, { 10.0, 10.0, 10.0 },
    { 1.0, 2.0, 0.3 } };
  for (int cellType : { VTK_TETRA, VTK_HEXAHEDRON })
  {
    for (const double* scale : scales)
    {
      TestOracleScene scene;
      scene.Volume->SetScale(scale[0], scale[1], scale[2]);
      scene.Volume->RotateX(30.0);
      scene.Volume->RotateZ(20.0);
      scene.Volume->SetPosition(0.1 * scale[0], -0.2 * scale[0], 0.3 * scale[0]);
      scene.Camera->SetPosition(1.1 * scale[0], 0.7 * scale[0], 5.0 * scale[0]);
      scene.Camera->SetFocalPoint(0.0, 0.0, 0.0);
      TestOracleBox box;
      box.CellType = cellType;
      CheckBox(checks, scene, box, 0.8 / scale[0], 1e-9);
    }
  }
}

/** Near and far plane inside the box; the camera inside the box. */
void CheckClippingRange(TestOracleChecks& checks)
{
  for (int cellType : { VTK_TETRA, VTK_HEXAHEDRON, VTK_POLYHEDRON })
  {
    for (bool parallel : { false, true })
    {
      TestOracleScene scene;
      scene.Camera->SetParallelProjection(parallel);
      scene.Camera->SetClippingRange(3.6, 4.3);
      TestOracleBox box;
      box.CellType = cellType;
      CheckBox(checks, scene, box, 0.8, 1e-9);
      scene.Camera->SetPosition(0.3, 0.2, 0.1);
      scene.Camera->SetFocalPoint(0.7, -0.4, -2.0);
      scene.Camera->SetClippingRange(0.01, 100.0);
      CheckBox(checks, scene, box, 0.8, 1e-9);
      CHECK_TRUE(checks, scene.GetValue(0, 0, 3) > 0.0 || parallel);
    }
  }
}

void CheckClippingPlanes(TestOracleChecks& checks)
{
  TestOracleScene scene;
  vtkNew<vtkPlane> left, front;
  left->SetOrigin(0.25, 0.0, 0.0);
  left->SetNormal(-1.0, 0.0, 0.0);
  front->SetOrigin(0.0, 0.0, 0.5);
  front->SetNormal(0.0, 0.0, -2.0);
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(left);
  planes->AddItem(front);
  scene.Oracle->SetClippingPlanes(planes);
  TestOracleBox box;
  const auto cut = [&](int column, int row, std::array<double, 2>& interval) {
    interval = scene.GetInterval(column, row, { -1.0, 0.25, -1.0, 1.0, -1.0, 0.5 });
  };
  CheckBox(checks, scene, box, 0.8, 1e-9, cut);
  box.CellType = VTK_TETRA;
  CheckBox(checks, scene, box, 0.8, 1e-9, cut);
}

/** An opaque plane across the view axis inside the box, behind a part of the pixels only. */
void CheckOpaqueDepth(TestOracleChecks& checks)
{
  const double distance = 4.0, near = 2.0, far = 9.0;
  for (bool parallel : { false, true })
  {
    TestOracleScene scene;
    scene.Camera->SetParallelProjection(parallel);
    scene.Camera->SetClippingRange(near, far);
    // OpenGL's window depth of a plane at this distance from the eye.
    const double depth = parallel ? (distance - near) / (far - near)
                                  : (1.0 / near - 1.0 / distance) / (1.0 / near - 1.0 / far);
    vtkNew<vtkDoubleArray> depths;
    for (int pixel = 0; pixel < scene.Width * scene.Height; ++pixel)
    {
      depths->InsertNextValue(pixel / scene.Width < 10 ? depth : 1.0);
    }
    scene.Oracle->SetOpaqueDepth(depths);
    const auto cut = [&](int column, int row, std::array<double, 2>& interval)
    {
      double start[3], direction[3], cosine;
      scene.GetRay(column, row, start, direction, cosine);
      interval[1] = row < 10 ? std::min(interval[1], distance / cosine) : interval[1];
    };
    CheckBox(checks, scene, TestOracleBox(), 0.8, 1e-9, cut);
  }
}

/** A small box at UTM coordinates: 1e7 costs nine digits of the eye's place and no more. */
void CheckFarCoordinates(TestOracleChecks& checks)
{
  const double x = 5e5, y = 1e7;
  TestOracleScene scene;
  scene.Camera->SetPosition(x + 1.0, y + 0.5, 4.0);
  scene.Camera->SetFocalPoint(x, y, 0.0);
  TestOracleBox box;
  box.Bounds = { x - 1.0, x + 1.0, y - 1.0, y + 1.0, -1.0, 1.0 };
  CheckBox(checks, scene, box, 0.8, 1e-7);
}
}

int TestOracleSlab(int, char*[])
{
  TestOracleChecks checks(__FILE__);
  CheckCellTypes(checks);
  CheckThinBoxes(checks);
  CheckOpaqueBox(checks);
  CheckActorMatrices(checks);
  CheckClippingRange(checks);
  CheckClippingPlanes(checks);
  CheckOpaqueDepth(checks);
  CheckFarCoordinates(checks);
  return checks.GetResult();
}
