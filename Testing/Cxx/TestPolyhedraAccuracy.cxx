// Every kind of convex cell, drawn as it is, against the oracle: sums to 1e-4, an extremum's scalar
// to 1e-5 of its range; three views, one with the camera inside.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"

int TestPolyhedraAccuracy(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMeshes::Entry& mesh : PolyhedraMeshes::All())
  {
    for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
    {
      PolyhedraScene scene(mapper.Make(), 96, 96);
      scene.SetMesh(mesh.Mesh);
      for (int view = 0; view < PolyhedraScene::NumberOfViews; ++view)
      {
        scene.SetView(view);
        const std::string name = mesh.Name + ", " + mapper.Name + ", view " + std::to_string(view);
        scene.CheckWithOracle(checks, name, __LINE__);
      }
    }
  }
  return checks.Result();
}
