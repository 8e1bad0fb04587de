// Colour functions of every kind, gray, unit distance, cell scalars, components and array choice,
// against the oracle.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <cmath>

namespace
{
void CheckScene(TestChecks& checks, TestScene& scene, const std::string& name, double bound = 3e-4)
{
  const double error = scene.MaximumError(name);
  checks.Check(error >= 0.0 && error <= bound, name.c_str(), __LINE__, std::to_string(error));
}

void CheckColorFunctions(TestChecks& checks)
{
  TestScene scene;
  auto grid = TestMeshes::SixTetrahedra();
  scene.SetGrid(grid);
  vtkColorTransferFunction* color = scene.Color;
  color->SetColorSpaceToDiverging();
  CheckScene(checks, scene, "Diverging");
  color->SetColorSpaceToLab();
  CheckScene(checks, scene, "Lab");
  color->SetColorSpaceToHSV();
  CheckScene(checks, scene, "HSV");
  color->SetColorSpaceToRGB();
  color->RemoveAllPoints();
  color->AddRGBPoint(0.05, 0.0, 0.0, 1.0, 0.3, 0.6);
  color->AddRGBPoint(0.6, 1.0, 0.5, 0.0, 0.5, 1.0);
  color->AddRGBPoint(1.0, 0.1, 1.0, 0.2);
  CheckScene(checks, scene, "midpoint and sharpness");
  color->SetScaleToLog10();
  CheckScene(checks, scene, "logarithmic");
  // Eight decades, most of them next to zero.
  color->RemoveAllPoints();
  color->AddRGBPoint(1e-8, 0.0, 0.0, 1.0);
  color->AddRGBPoint(1e-3, 0.0, 1.0, 0.0);
  color->AddRGBPoint(1.0, 1.0, 0.0, 0.0);
  TestMeshes::SetField(grid, [](const double* p) { return std::pow(10.0, -8.0 * (p[0] + 0.5)); });
  CheckScene(checks, scene, "eight decades");
  TestMeshes::SetField(grid, TestMeshes::Waves);
  color->SetScaleToLinear();
  color->ClampingOff();
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.2, 3.0, 0.25, 1.0);
  scene.Opacity->AddPoint(0.7, 1.0, 0.7, 0.5);
  scene.Opacity->AddPoint(0.8, 6.0);
  scene.Opacity->ClampingOff();
  CheckScene(checks, scene, "clamping off, steps");
}

void CheckGrayAndDistance(TestChecks& checks)
{
  TestScene scene;
  scene.SetGrid(TestMeshes::SixTetrahedra());
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0.0, 0.2);
  gray->AddPoint(0.4, 1.0);
  gray->AddPoint(1.0, 0.5);
  scene.Property->SetColor(gray);
  CheckScene(checks, scene, "gray");
  scene.Property->SetScalarOpacityUnitDistance(0.1);
  CheckScene(checks, scene, "unit distance .1");
  scene.Property->SetScalarOpacityUnitDistance(25.0);
  CheckScene(checks, scene, "unit distance 25");
  // Optically thick: 1000 and more per cell.
  scene.Property->SetScalarOpacityUnitDistance(1e-3);
  CheckScene(checks, scene, "unit distance .001", 1e-3);
  // Beyond the square root of the range of a float.
  scene.Property->SetScalarOpacityUnitDistance(1e-37);
  scene.Render();
  CHECK_NEAR(scene.CenterPixel()[3], 1.0, 1e-6);
}

void CheckCellScalars(TestChecks& checks)
{
  TestScene scene;
  auto grid = TestMeshes::SixTetrahedra();
  vtkNew<vtkDoubleArray> values;
  values->SetName("cells");
  for (int i = 0; i < 6; ++i)
  {
    values->InsertNextValue(0.15 * i);
  }
  grid->GetCellData()->AddArray(values);
  scene.SetGrid(grid);
  scene.Mapper->SetScalarModeToUseCellFieldData();
  scene.Mapper->SelectScalarArray("cells");
  scene.Oracle->SetCellScalars(true);
  scene.Oracle->SetArrayName("cells");
  CheckScene(checks, scene, "cell scalars");
  scene.SetSpiky();
  CheckScene(checks, scene, "cell scalars, spiky");
  // No point scalars: the default mode takes the cells' own.
  grid->GetPointData()->Initialize();
  grid->GetCellData()->SetActiveScalars("cells");
  scene.Mapper->SetScalarModeToDefault();
  CheckScene(checks, scene, "cell scalars by default");
}

void CheckComponents(TestChecks& checks)
{
  TestScene scene;
  auto grid = TestMeshes::SixTetrahedra();
  vtkNew<vtkDoubleArray> vectors, magnitude, second;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  magnitude->SetName("magnitude");
  second->SetName("second");
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    const double x = 0.1 * id, y = 0.3 + 0.05 * id, z = id % 2;
    vectors->InsertNextTuple3(x, y, z);
    second->InsertNextValue(y);
    magnitude->InsertNextValue(std::sqrt(x * x + y * y + z * z));
  }
  for (vtkDoubleArray* array :
    { vectors.GetPointer(), magnitude.GetPointer(), second.GetPointer() })
  {
    grid->GetPointData()->AddArray(array);
  }
  scene.SetGrid(grid);
  scene.Mapper->SetScalarModeToUsePointFieldData();
  scene.Mapper->SelectScalarArray("vectors");
  scene.Color->SetVectorModeToMagnitude();
  scene.Oracle->SetArrayName("magnitude");
  CheckScene(checks, scene, "magnitude");
  scene.Color->SetVectorModeToComponent();
  scene.Color->SetVectorComponent(1);
  scene.Oracle->SetArrayName("second");
  CheckScene(checks, scene, "component 1");
}
}

int TestProperty(int, char*[])
{
  TestChecks checks;
  CheckColorFunctions(checks);
  CheckGrayAndDistance(checks);
  CheckCellScalars(checks);
  CheckComponents(checks);
  return checks.Result();
}
