// M8: what is asked for and not drawn is named, once; a blend mode of the wrong kind says which
// mapper to use and changes nothing; the minimum is drawn.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"

#include "vtkHardwareSelector.h"
#include "vtkProjectedPolyhedraMapper.h"
#include "vtkSelection.h"

#include <functional>

namespace
{
void CheckWarning(TestChecks& checks, const PolyhedraMappers::Entry& mapper,
  const std::string& text, const std::function<void(TestScene&)>& ask)
{
  PolyhedraScene scene(mapper.Make());
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.SetMesh(PolyhedraMeshes::Hexahedra(2));
  scene.Render();
  auto before = scene.CopyCaptured();
  checks.Check(messages->Count() == 0, "silent before", __LINE__, text);
  ask(scene);
  scene.Render();
  scene.Render();
  checks.Check(messages->Count() == 1 && messages->CountOf(text) == 1, text.c_str(), __LINE__,
    mapper.Name + ": " + std::to_string(messages->Count()) + " messages");
  CHECK(TestScene::Difference(before, scene.Mapper->GetCapturedImage()) == 0.0);
  CHECK(scene.CountLitPixels() > 1000);
}

void CheckBlendModes(TestChecks& checks, const PolyhedraMappers::Entry& entry)
{
  const char* advice[6] = { "use vtkPreIntegratedTetrahedraMapper",
    "use vtkMaximumProjectionMapper", "use vtkMaximumProjectionMapper", "the modes are",
    "use vtkProjectedPolyhedraMapper", "use vtkBarycentricShellMapper" };
  vtkSmartPointer<vtkConvexCellMapper> mapper = entry.Make();
  const int own = mapper->GetBlendMode();
  vtkNew<MessageObserver> messages;
  messages->Watch(mapper);
  for (int mode = 0; mode < 6; ++mode)
  {
    const bool draws = own == vtkConvexCellMapper::ADDITIVE
                         ? mode == own
                         : mode == vtkConvexCellMapper::MAXIMUM_INTENSITY ||
                             mode == vtkConvexCellMapper::MINIMUM_INTENSITY;
    const int before = messages->Count();
    mapper->SetBlendMode(mode);
    checks.Check(messages->Count() - before == (draws ? 0 : 1), advice[mode], __LINE__, entry.Name);
    checks.Check(draws || messages->Texts.back().find(advice[mode]) != std::string::npos,
      advice[mode], __LINE__, entry.Name);
    CHECK(mapper->GetBlendMode() == (draws ? mode : own));
    mapper->SetBlendMode(own);
  }
}

// Between the least and the greatest scalar of a lattice seen through.
void CheckMinimum(TestChecks& checks)
{
  PolyhedraScene scene(PolyhedraMappers::All()[2].Make());
  auto grid = PolyhedraMeshes::Hexahedra(3);
  scene.SetMesh(grid);
  scene.Render();
  const double greatest = scene.CenterPixel()[0];
  scene.Mapper->SetBlendModeToMinimumIntensity();
  scene.Render();
  const double least = scene.CenterPixel()[0];
  CHECK_AT_MOST(least + 0.1, greatest);
  scene.Mapper->SetBlendModeToMaximumIntensity();
  scene.Render();
  CHECK(scene.CenterPixel()[0] == greatest);
}

void CheckPasses(TestChecks& checks)
{
  vtkNew<vtkProjectedPolyhedraMapper> mapper;
  vtkNew<MessageObserver> messages;
  messages->Watch(mapper);
  CHECK(mapper->GetPasses() == 1 && !mapper->GetAverageEmission());
  mapper->SetPassesToThree();
  CHECK(mapper->GetPasses() == 3);
  CHECK(messages->Count() == 0);
  for (const int passes : { 0, 2, -1, 4 })
  {
    mapper->SetPasses(passes);
  }
  CHECK(messages->Count() == 4 && messages->CountOf("it is 1 or 3") == 4);
  CHECK(mapper->GetPasses() == 3);
}

// A hardware selection pass draws ids: a volume must leave no colours in it.
void CheckSelectionPass(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make());
  scene.SetMesh(PolyhedraMeshes::Hexahedra(2));
  scene.Render();
  vtkImageData* drawn = scene.Mapper->GetCapturedImage();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, 127, 127);
  auto selection = vtk::TakeSmartPointer(selector->Select());
  CHECK(selection && selection->GetNumberOfNodes() == 0);
  CHECK(scene.Mapper->GetCapturedImage() == drawn);
  scene.Render();
  CHECK(scene.CountLitPixels() > 1000);
}
}

int TestPolyhedraUnsupported(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    CheckWarning(checks, mapper, "Shade is on", [](TestScene& s) { s.Property->ShadeOn(); });
    CheckWarning(checks, mapper, "Interpolation is nearest",
      [](TestScene& s) { s.Property->SetInterpolationTypeToNearest(); });
    CheckWarning(checks, mapper, "gradient opacity",
      [](TestScene& s)
      {
        vtkNew<vtkPiecewiseFunction> function;
        function->AddPoint(0.0, 0.5);
        s.Property->SetGradientOpacity(function);
      });
    CheckWarning(checks, mapper, "two-dimensional transfer function",
      [](TestScene& s) { s.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D); });
    if (mapper.ThreePasses)
    {
      CheckWarning(checks, mapper, "Tiles engine does not draw three passes",
        [](TestScene& s) { s.Mapper->SetEngineToTiles(); });
    }
    CheckBlendModes(checks, mapper);
    CheckSelectionPass(checks, mapper);
  }
  CheckMinimum(checks);
  CheckPasses(checks);
  return checks.Result();
}
