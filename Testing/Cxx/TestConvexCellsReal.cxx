// Real meshes: how many cells are not convex, and whether the cells that go out have the volume of
// those that came in. Needs CELLPROJECTION_DATA.
#include "ConvexCellsTesting.h"
#include "RealMeshes.h"

#include "vtkUnstructuredGridReader.h"

#include <fstream>
#include <string>

namespace
{
using namespace ConvexCellsTesting;
constexpr int Skipped = 125;

struct Expectation
{
  const char* Name;
  vtkIdType Cells;
  vtkIdType NonConvex;
  vtkIdType Degenerate; // repeat a point
  vtkIdType Folded;
};

// The crushed can is dented; the hexagons of PentaHexa are warped by 0.7 % of their size, some of
// its pentagons by 2e-6.
const Expectation Expectations[] = { { "bluntFin", 37479, 0, 39, 0 }, { "comb", 43008, 2, 0, 0 },
  { "post", 102675, 0, 0, 0 }, { "diskOut", 7472, 0, 0, 0 }, { "can", 4800, 703, 0, 33 },
  { "fire", 10462, 0, 0, 0 }, { "hexa", 10648, 0, 0, 0 }, { "PentaHexa", 210, 120, 42, 0 } };

vtkSmartPointer<vtkUnstructuredGrid> ReadMesh(const std::string& name)
{
  if (name != "hexa" && name != "PentaHexa")
  {
    return RealMeshes::Read(name);
  }
  const char* folder = std::getenv("CELLPROJECTION_DATA");
  const std::string file = std::string(folder ? folder : ".") + "/" + name + ".vtk";
  vtkNew<vtkUnstructuredGridReader> reader;
  if (!std::ifstream(file))
  {
    return nullptr;
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

// Cells that were wound inward have a negative volume before, and a positive one after.
double AbsoluteVolume(vtkUnstructuredGrid* grid)
{
  double volume = 0.0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    volume += std::abs(VolumeWithin(grid->GetCell(cell)));
  }
  return volume;
}

void CheckMesh(const Expectation& mesh, vtkUnstructuredGrid* grid)
{
  CHECK_EQUAL(grid->GetNumberOfCells(), mesh.Cells);
  auto whole = Run(grid, false);
  auto tetrahedra = Run(grid, true);
  CHECK_EQUAL(whole->GetNumberOfSkippedCells(), 0);
  CHECK_EQUAL(whole->GetNumberOfNonConvexCells(), mesh.NonConvex);
  CHECK_EQUAL(whole->GetNumberOfDegenerateCells(), mesh.Degenerate);
  CHECK_EQUAL(whole->GetOutput()->GetNumberOfCells() - CountType(whole->GetOutput(), VTK_TETRA),
    mesh.Cells - mesh.NonConvex - mesh.Degenerate);
  CHECK_EQUAL(whole->GetNumberOfFoldedCells(), mesh.Folded);
  CHECK_EQUAL(tetrahedra->GetNumberOfFoldedCells(), mesh.Folded);
  const double volume = TotalVolume(tetrahedra->GetOutput());
  CHECK(Near(VolumeWithin(whole->GetOutput()), volume, 1e-9));
  // Folded cells overlap; merged points can change a diagonal.
  CHECK(mesh.Folded > 0 ? volume > AbsoluteVolume(grid)
                        : Near(AbsoluteVolume(grid), volume, mesh.Degenerate > 0 ? 1e-4 : 1e-9));
  std::cout << mesh.Name << ": " << mesh.Cells << " cells, " << whole->GetNumberOfNonConvexCells()
            << " not convex, " << whole->GetNumberOfDegenerateCells() << " repeat a point, "
            << whole->GetNumberOfFoldedCells() << " folded; volume " << volume << " for "
            << AbsoluteVolume(grid) << "\n";
}
}

int TestConvexCellsReal(int, char*[])
{
  bool any = false;
  for (const Expectation& mesh : Expectations)
  {
    if (auto grid = ReadMesh(mesh.Name))
    {
      CheckMesh(mesh, grid);
      any = true;
    }
  }
  return any ? Result() : Skipped;
}
