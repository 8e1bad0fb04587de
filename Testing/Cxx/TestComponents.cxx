// Dependent components: of two the first is the colour's scalar and the second the opacity's, of
// four the first three are the colour. Against pictures of one component that show the same, and
// against the oracle.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
const double First[3] = { 0.1, 0.2, 0.9 };
const double Last[3] = { 0.9, 0.7, 0.1 };

class ComponentScene : public TestScene
{
public:
  vtkSmartPointer<vtkUnstructuredGrid> Grid = TestMeshes::Delaunay(100);

  ComponentScene()
    : TestScene(64, 64)
  {
    TestMeshes::SetField(this->Grid, TestMeshes::Waves);
    this->SetGrid(this->Grid);
  }

  /// Colour from First to Last, opacity with spikes.
  void SetRamp()
  {
    this->SetSpiky();
    this->Color->RemoveAllPoints();
    this->Color->AddRGBPoint(0.0, First[0], First[1], First[2]);
    this->Color->AddRGBPoint(1.0, Last[0], Last[1], Last[2]);
  }

  /// Every point gets a tuple of its scalar's.
  template <class Make>
  void SetComponents(vtkDataArray* array, int components, Make make)
  {
    vtkSmartPointer<vtkDataArray> scalars = this->Grid->GetPointData()->GetScalars();
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(scalars->GetNumberOfTuples());
    for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
    {
      for (int i = 0; i < components; ++i)
      {
        array->SetComponent(id, i, make(scalars->GetComponent(id, 0), i));
      }
    }
    array->SetName("components");
    this->Grid->GetPointData()->SetScalars(array);
    this->Property->IndependentComponentsOff();
  }
};

double Color(double scalar, int channel)
{
  return First[channel] + scalar * (Last[channel] - First[channel]);
}

double DifferenceTo(ComponentScene& scene, vtkImageData* expected)
{
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.Render();
  const double difference = TestScene::Difference(expected, scene.Mapper->GetCapturedImage());
  return messages->Count() == 0 ? difference : 1.0;
}

void CheckTwo(TestChecks& checks, bool lit)
{
  ComponentScene one, two;
  for (ComponentScene* each : { &one, &two })
  {
    each->SetSpiky();
    each->Property->SetShade(lit);
  }
  one.Render();
  // The colour function is asked for 1 - s, and mirrored.
  vtkNew<vtkDoubleArray> pairs;
  two.SetComponents(pairs, 2, [](double s, int i) { return i == 0 ? 1.0 - s : s; });
  two.Color->RemoveAllPoints();
  two.Color->AddRGBPoint(1.0, 0.1, 0.2, 0.9);
  two.Color->AddRGBPoint(0.5, 0.9, 0.9, 0.2);
  two.Color->AddRGBPoint(0.0, 0.9, 0.1, 0.1);
  const double difference = DifferenceTo(two, one.Mapper->GetCapturedImage());
  CHECK_AT_MOST(difference, 1e-3);
  // The colour function changes the next frame.
  two.Color->AddRGBPoint(0.7, 0.0, 1.0, 0.0);
  CHECK(DifferenceTo(two, one.Mapper->GetCapturedImage()) > 0.05);
}

void CheckFour(TestChecks& checks, bool lit)
{
  ComponentScene one, four, bytes;
  for (ComponentScene* each : { &one, &four, &bytes })
  {
    each->SetRamp();
    each->Property->SetShade(lit);
  }
  one.Render();
  vtkNew<vtkDoubleArray> colors;
  four.SetComponents(colors, 4, [](double s, int i) { return i < 3 ? Color(s, i) : s; });
  const double difference = DifferenceTo(four, one.Mapper->GetCapturedImage());
  CHECK_AT_MOST(difference, 1e-3);
  // The fourth byte goes through the opacity function, which is that of 0 to 255.
  vtkNew<vtkUnsignedCharArray> rounded;
  bytes.SetComponents(
    rounded, 4, [](double s, int i) { return std::round(255.0 * (i < 3 ? Color(s, i) : s)); });
  bytes.Opacity->RemoveAllPoints();
  for (int i = 0; i < 9; ++i)
  {
    bytes.Opacity->AddPoint(255.0 * i / 8.0, i % 2 == 0 ? 0.0 : 4.0 + 6.0 * (i % 3));
  }
  const double byteDifference = DifferenceTo(bytes, one.Mapper->GetCapturedImage());
  CHECK_AT_MOST(byteDifference, 0.05);
  four.GetTetrahedraMapper()->SetIntegrationToAverage();
  one.GetTetrahedraMapper()->SetIntegrationToAverage();
  one.Render();
  CHECK_AT_MOST(DifferenceTo(four, one.Mapper->GetCapturedImage()), 1e-3);
}

void CheckError(TestChecks& checks, ComponentScene& scene, const std::string& name)
{
  const double error = scene.MaximumError(name);
  const double bound = scene.Property->GetShade() ? 1e-3 : 1e-4;
  checks.Check(error >= 0.0 && error <= bound, name.c_str(), __LINE__, std::to_string(error));
}

// Components of which none follows from another.
double Component(double scalar, int i)
{
  return 0.5 + 0.5 * std::sin((3.0 + i) * scalar + 2.0 * i);
}

void CheckOracle(TestChecks& checks, bool lit)
{
  for (const int components : { 1, 2, 4 })
  {
    ComponentScene scene;
    scene.SetSpiky();
    scene.Color->AddRGBPoint(0.3, 0.0, 1.0, 0.0);
    scene.Property->SetShade(lit);
    vtkNew<vtkDoubleArray> values;
    scene.SetComponents(values, components, Component);
    CheckError(checks, scene, std::to_string(components) + " components");
    scene.LookFrom(0.1, -0.05, 0.2);
    CheckError(checks, scene, std::to_string(components) + " components, inside");
    // Independent: another component, another picture.
    const auto dependent = scene.CopyCaptured();
    scene.Property->IndependentComponentsOn();
    CheckError(checks, scene, std::to_string(components) + " independent components");
    const double change = TestScene::Difference(dependent, scene.Mapper->GetCapturedImage());
    CHECK(components == 1 ? change < 1e-4 : change > 0.05);
  }
  ComponentScene bytes;
  bytes.Property->SetShade(lit);
  bytes.Opacity->AddPoint(255.0, 9.0);
  vtkNew<vtkUnsignedCharArray> values;
  bytes.SetComponents(
    values, 4, [](double s, int i) { return std::round(255.0 * Component(s, i)); });
  CheckError(checks, bytes, "4 bytes");
}

void CheckTable(TestChecks& checks)
{
  ComponentScene scene;
  // Tables are Raster's.
  scene.Mapper->SetEngineToRaster();
  scene.SetRamp();
  vtkNew<vtkDoubleArray> colors;
  scene.SetComponents(colors, 4, [](double s, int i) { return i < 3 ? Color(s, i) : s; });
  scene.Render();
  auto exact = scene.CopyCaptured();
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.GetTetrahedraMapper()->SetIntegrationToTable();
  scene.Render();
  scene.Render();
  CHECK(messages->Count() == 1 && messages->CountOf("A table holds one scalar") == 1);
  CHECK(TestScene::Difference(exact, scene.Mapper->GetCapturedImage()) == 0.0);
}
}

int TestComponents(int, char*[])
{
  TestChecks checks;
  for (const bool lit : { false, true })
  {
    CheckTwo(checks, lit);
    CheckFour(checks, lit);
    CheckOracle(checks, lit);
  }
  CheckTable(checks);
  return checks.Result();
}
