// GL names belong to their context: a mapper that changes windows, or dies while another window is
// current, leaves alone what others made there.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

namespace
{
/// A window with a white ball in its middle.
class BallWindow
{
public:
  BallWindow()
  {
    vtkNew<vtkSphereSource> ball;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(128, 128);
    this->Window->AddRenderer(this->Renderer);
  }
  bool ShowsBall()
  {
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixel;
    this->Window->GetPixelData(64, 64, 64, 64, 0, pixel);
    return pixel->GetComponent(0, 0) > 100.0;
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};
}

int TestContexts(int, char*[])
{
  TestChecks checks;
  BallWindow other;
  CHECK(other.ShowsBall());
  {
    TestScene scene;
    scene.SetGrid(TestMeshes::SixTetrahedra());
    scene.Render();
    CHECK(other.ShowsBall());
    // The volume goes to the other window and back.
    other.Renderer->AddVolume(scene.Volume);
    other.Window->Render();
    scene.Render();
    other.Window->Render();
    other.Renderer->RemoveVolume(scene.Volume);
    CHECK(other.ShowsBall());
    scene.Render();
    CHECK(scene.CenterPixel()[3] > 0.1);
    // The other window is current when the volume takes another mapper.
    CHECK(other.ShowsBall());
    vtkNew<vtkPreIntegratedTetrahedraMapper> replacement;
    replacement->SetInputData(scene.Mapper->GetInput());
    scene.Volume->SetMapper(replacement);
    CHECK(other.ShowsBall());
    scene.Render();
    CHECK(other.ShowsBall());
  }
  // The scene's window and mappers are gone.
  CHECK(other.ShowsBall());
  return checks.Result();
}
