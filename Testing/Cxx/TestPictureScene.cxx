// A picture: a bent lattice of hexahedra with an opaque ball and a tube in it, clipped, on a
// gradient.

#include "TestMeshes.h"
#include "TestPicture.h"
#include "TestScene.h"

#include "vtkActor.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

namespace
{
void AddBall(vtkRenderer* renderer, double x, double y, double z)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(x, y, z);
  ball->SetRadius(0.25);
  ball->SetThetaResolution(40);
  ball->SetPhiResolution(40);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.85, 0.7);
  renderer->AddActor(actor);
}
}

int TestPictureScene(int argc, char* argv[])
{
  TestScene scene(256, 256);
  scene.SetGrid(TestMeshes::Curvilinear(8));
  scene.SetSpiky();
  AddBall(scene.Renderer, 0.2, 0.1, 0.3);
  AddBall(scene.Renderer, -0.3, 0.75, 0.0);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.45);
  plane->SetNormal(-0.3, 0.2, -1.0);
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  scene.Mapper->SetClippingPlanes(planes);
  scene.Renderer->SetBackground(0.1, 0.15, 0.3);
  scene.LookFrom(1.4, 1.7, 2.5);
  scene.Render();
  return AgreesWithBaseline(argc, argv, scene.Window) ? 0 : 1;
}
