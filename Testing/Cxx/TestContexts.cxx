// GL names belong to their context: a mapper that changes windows, or dies while another window is
// current, leaves alone what others made there; and what observers draw elsewhere leaves it alone.

#include "OpaquePlane.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
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

void DrawBall(vtkObject*, unsigned long, void* window, void*)
{
  static_cast<BallWindow*>(window)->Window->Render();
}

/// An opaque plane through a volume, of which the mapper says something in every first frame.
class WarningScene : public TestScene
{
public:
  explicit WarningScene(int engine)
  {
    this->Mapper->SetEngine(engine);
    this->SetGrid(TestMeshes::SixTetrahedra());
    OpaquePlane::AddSlanted(*this);
    this->Warn(0);
  }
  /// Another warning than that of the frame before, about the property, that changes no pixel.
  void Warn(int number)
  {
    this->Opacity->RemoveAllPoints();
    this->Opacity->AddPoint(0.0, 0.1);
    this->Opacity->AddPoint(1.0, 2.0);
    for (int i = 0; i <= number; ++i)
    {
      this->Opacity->AddPoint(-10.0 - i, -1.0);
    }
    this->Opacity->AddPoint(-9.0, 0.1);
  }
};

// What is told of a frame may draw elsewhere: of a new mesh by its progress, else by a warning.
void CheckObservers(TestChecks& checks, int engine)
{
  WarningScene alone(engine), told(engine);
  BallWindow other;
  CHECK(other.ShowsBall());
  vtkNew<vtkCallbackCommand> draws;
  draws->SetCallback(DrawBall);
  draws->SetClientData(&other);
  vtkNew<MessageObserver> messages;
  messages->Watch(told.Mapper);
  vtkNew<MessageObserver> unheard;
  unheard->Watch(alone.Mapper);
  told.Mapper->AddObserver(vtkCommand::ProgressEvent, draws);
  told.Mapper->AddObserver(vtkCommand::WarningEvent, draws);
  for (int frame = 0; frame < 3; ++frame)
  {
    alone.Warn(frame);
    alone.Render();
    told.Warn(frame);
    told.Render();
    CHECK(messages->Count() == frame + 1);
    CHECK(alone.CenterPixel()[3] > 0.1);
    const double difference = TestScene::Difference(alone.CopyCaptured(), told.CopyCaptured());
    checks.Check(difference == 0.0, engine == vtkConvexCellMapper::TILES ? "Tiles" : "Raster",
      __LINE__, std::to_string(frame));
    CHECK(other.ShowsBall());
  }
}
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
  for (const int engine : { vtkConvexCellMapper::TILES, vtkConvexCellMapper::RASTER })
  {
    CheckObservers(checks, engine);
  }
  // The scenes' windows and mappers are gone.
  CHECK(other.ShowsBall());
  return checks.Result();
}
