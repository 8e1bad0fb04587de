// A volume that two windows show leaves either of them, or either is closed, in any order: the
// other window's GL objects are untouched and the volume is still drawn there.

#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

namespace
{
/// A window with a row of balls, each with GL objects of its own.
class BallWindow
{
public:
  BallWindow()
  {
    for (int i = 0; i < 12; ++i)
    {
      vtkNew<vtkSphereSource> ball;
      ball->SetCenter(0.7 * i, 0.0, 0.0);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(ball->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      this->Renderer->AddActor(actor);
    }
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(96, 96);
    this->Window->AddRenderer(this->Renderer);
  }
  std::vector<unsigned char> Pixels()
  {
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, 95, 95, 0, pixels);
    return std::vector<unsigned char>(
      pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

void Check(TestChecks& checks, vtkConvexCellMapper* mapper)
{
  PolyhedraScene scene(mapper, 64, 64);
  scene.SetMesh(TestMeshes::Curvilinear(2));
  scene.Render();
  auto expected = scene.CopyCaptured();
  {
    // Opening a window asks all of its volumes to let go of it.
    BallWindow opened;
    opened.Renderer->AddVolume(scene.Volume);
    opened.Window->Render();
    scene.Render();
    CHECK(TestScene::Difference(expected, scene.CopyCaptured()) == 0.0);
  }
  BallWindow other;
  const std::vector<unsigned char> balls = other.Pixels();
  // Its buffers are the scene's, the other window lets it go.
  other.Renderer->AddVolume(scene.Volume);
  other.Window->Render();
  scene.Render();
  other.Renderer->RemoveVolume(scene.Volume);
  scene.Render();
  CHECK(TestScene::Difference(expected, scene.CopyCaptured()) == 0.0);
  CHECK(other.Pixels() == balls);
  // Its buffers are the other window's, the scene lets it go.
  other.Renderer->AddVolume(scene.Volume);
  other.Window->Render();
  const std::vector<unsigned char> both = other.Pixels();
  scene.Renderer->RemoveVolume(scene.Volume);
  scene.Window->Render();
  CHECK(other.Pixels() == both);
  // The scene's window is closed while it holds the buffers.
  scene.Renderer->AddVolume(scene.Volume);
  scene.Render();
  scene.Window->Finalize();
  CHECK(other.Pixels() == both);
  scene.Render();
  CHECK(TestScene::Difference(expected, scene.CopyCaptured()) == 0.0);
}
}

int TestSharedVolume(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    Check(checks, mapper.Make());
  }
  Check(checks, vtkSmartPointer<vtkPreIntegratedTetrahedraMapper>::New());
  return checks.Result();
}
