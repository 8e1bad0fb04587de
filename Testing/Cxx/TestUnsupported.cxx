// What is asked for and not drawn is named, once; a blend mode that is not drawn changes nothing.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkDoubleArray.h"
#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkSelection.h"

namespace
{
void CheckWarning(TestChecks& checks, const std::string& text, void (*ask)(TestScene&))
{
  TestScene scene;
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.Render();
  checks.Check(messages->Count() == 0, "silent before", __LINE__, text);
  ask(scene);
  scene.Render();
  scene.Render();
  checks.Check(messages->Count() == 1 && messages->CountOf(text) == 1, text.c_str(), __LINE__,
    std::to_string(messages->Count()) + " messages");
  checks.Check(scene.CenterPixel()[3] > 0.1, "drawn all the same", __LINE__, text);
}

void CheckBlendModes(TestChecks& checks)
{
  vtkNew<vtkPreIntegratedTetrahedraMapper> mapper;
  vtkNew<MessageObserver> messages;
  messages->Watch(mapper);
  CHECK(mapper->GetBlendMode() == 0);
  mapper->SetBlendModeToComposite();
  CHECK(messages->Count() == 0);
  mapper->SetBlendModeToMaximumIntensity();
  mapper->SetBlendModeToMinimumIntensity();
  CHECK(messages->CountOf("use vtkMaximumProjectionMapper") == 2);
  mapper->SetBlendModeToAdditive();
  CHECK(messages->CountOf("use vtkProjectedPolyhedraMapper") == 1);
  mapper->SetBlendModeToIsoSurface();
  CHECK(messages->CountOf("use vtkBarycentricShellMapper") == 1);
  CHECK(mapper->GetBlendMode() == 0);
}

// A hardware selection pass draws ids: a volume must leave no colours in it.
void CheckSelectionPass(TestChecks& checks)
{
  TestScene scene;
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.Render();
  vtkImageData* drawn = scene.Mapper->GetCapturedImage();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, 127, 127);
  vtkSelection* selection = selector->Select();
  CHECK(selection && selection->GetNumberOfNodes() == 0);
  // No frame was drawn: the image of the last one is still there.
  CHECK(scene.Mapper->GetCapturedImage() == drawn);
  selection->Delete();
  scene.Render();
  CHECK(scene.CenterPixel()[3] > 0.1);
}
}

int TestUnsupported(int, char*[])
{
  TestChecks checks;
  CheckWarning(checks, "Interpolation is nearest",
    [](TestScene& s) { s.Property->SetInterpolationTypeToNearest(); });
  CheckWarning(checks, "2 lights have no direction",
    [](TestScene& s)
    {
      for (int i = 0; i < 2; ++i)
      {
        vtkNew<vtkLight> light;
        light->SetFocalPoint(light->GetPosition());
        s.Renderer->AddLight(light);
      }
      s.Property->ShadeOn();
    });
  CheckWarning(checks, "5 lights do not shine: the first 16 do",
    [](TestScene& s)
    {
      for (int i = 0; i < 20; ++i)
      {
        vtkNew<vtkLight> light;
        s.Renderer->AddLight(light);
      }
      s.Property->ShadeOn();
    });
  CheckWarning(checks, "two-dimensional transfer function",
    [](TestScene& s) { s.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D); });
  CheckWarning(checks, "IndependentComponents is off",
    [](TestScene& s)
    {
      vtkNew<vtkDoubleArray> three;
      three->SetNumberOfComponents(3);
      for (vtkIdType id = 0; id < s.Mapper->GetInput()->GetNumberOfPoints(); ++id)
      {
        three->InsertNextTuple3(0.1 * id, 1.0, 1.0);
      }
      s.Mapper->GetInput()->GetPointData()->SetScalars(three);
      s.Property->IndependentComponentsOff();
    });
  CheckWarning(checks, "The Tiles engine does not draw by table",
    [](TestScene& s)
    {
      s.Mapper->SetEngineToTiles();
      s.GetTetrahedraMapper()->SetIntegrationToTable();
    });
  CheckBlendModes(checks);
  CheckSelectionPass(checks);
  return checks.Result();
}
