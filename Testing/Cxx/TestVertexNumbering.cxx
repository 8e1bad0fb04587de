// M3: one tetrahedron has one image, whichever of the 24 ways its corners are numbered.

#include "TestMeshes.h"
#include "TestScene.h"

#include <algorithm>

int TestVertexNumbering(int, char*[])
{
  TestChecks checks;
  TestScene scene;
  std::vector<int> numbering = { 0, 1, 2, 3 };
  scene.SetGrid(TestMeshes::Tetrahedron(numbering));
  scene.Render();
  auto first = scene.CopyCaptured();
  CHECK(scene.CenterPixel()[3] > 0.1);
  while (std::next_permutation(numbering.begin(), numbering.end()))
  {
    scene.SetGrid(TestMeshes::Tetrahedron(numbering));
    scene.Render();
    const double difference = TestScene::Difference(first, scene.Mapper->GetCapturedImage());
    CHECK(difference >= 0.0);
    CHECK_AT_MOST(difference, 2e-6);
  }
  return checks.Result();
}
