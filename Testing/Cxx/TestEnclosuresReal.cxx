// What fills real meshes to hull and box: convex cells, volumes that add up. Needs
// CELLPROJECTION_DATA. Arguments: one mesh's name.

#include "EnclosureCheck.h"
#include "RealMeshes.h"
#include "TestScene.h"
#include "vtkConvexifyFilter.h"

namespace
{
// Of the diagonal. Thousands of cuts through the comb's warped walls add up to 2e-9.
constexpr double LargestDent = 1e-8;
}

int TestEnclosuresReal(int argc, char* argv[])
{
  constexpr int Skipped = 125;
  TestChecks checks;
  const std::string only = argc > 1 && argv[1][0] != '-' ? argv[1] : "";
  int read = 0;
  for (const std::string name : { "bluntFin", "comb", "post", "fire", "diskOut" })
  {
    auto grid = only.empty() || only == name ? RealMeshes::Read(name) : nullptr;
    for (int enclosure = 0; enclosure < 2 && grid; ++enclosure)
    {
      ++read;
      vtkNew<vtkConvexifyFilter> filter;
      filter->SetInputData(grid);
      filter->SetEnclosure(enclosure);
      filter->DiscardOutsideHullOff();
      filter->Update();
      EnclosureCheck::TestFilled(
        checks, name + (enclosure == 0 ? " in its hull" : " in its box"), filter, LargestDent);
    }
  }
  return read == 0 ? Skipped : checks.Result();
}
