// Clipping planes cut per pixel, in world coordinates, in both projections; seven are too many.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

namespace
{
void CheckCuts(TestChecks& checks, TestScene& scene, vtkPlaneCollection* collection)
{
  const double planes[3][6] = { { 0.1, 0.0, 0.0, 1.0, 0.3, 0.2 }, { 0.0, 0.2, 0.0, 0.0, -1.0, 0.1 },
    { 0.0, 0.0, -0.3, 0.2, 0.1, 2.0 } };
  for (const auto& numbers : planes)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(numbers);
    plane->SetNormal(numbers + 3);
    collection->AddItem(plane);
    for (const int parallel : { 0, 1 })
    {
      scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
      const std::string name =
        std::to_string(collection->GetNumberOfItems()) + " planes" + (parallel ? ", parallel" : "");
      const double error = scene.MaximumError(name);
      CHECK(error >= 0.0);
      CHECK_AT_MOST(error, 1e-4);
    }
  }
}

void CheckMovedPlane(TestChecks& checks, TestScene& scene, vtkPlaneCollection* collection)
{
  // A plane that moves moves the cut.
  scene.Render();
  auto before = scene.CopyCaptured();
  collection->GetItem(0)->SetOrigin(-0.1, 0.0, 0.0);
  scene.Render();
  CHECK(TestScene::Difference(before, scene.Mapper->GetCapturedImage()) > 1e-2);
}

void CheckTooMany(TestChecks& checks, TestScene& scene, vtkPlaneCollection* collection)
{
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  while (collection->GetNumberOfItems() < 7)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.0, 0.0, -5.0);
    collection->AddItem(plane);
  }
  scene.Render();
  scene.Render();
  CHECK(messages->Count() == 1 && messages->CountOf("7 clipping planes") == 1);
}
}

int TestClippingPlanes(int, char*[])
{
  TestChecks checks;
  TestScene scene;
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.Volume->RotateY(20.0);
  scene.Volume->SetScale(1.0, 1.2, 0.9);
  vtkNew<vtkPlaneCollection> collection;
  scene.Mapper->SetClippingPlanes(collection);
  scene.Oracle->SetClippingPlanes(collection);
  CheckCuts(checks, scene, collection);
  CheckMovedPlane(checks, scene, collection);
  CheckTooMany(checks, scene, collection);
  return checks.Result();
}
