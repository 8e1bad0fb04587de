// The table of all meshes, good and bad.
#include "SortMeshes.h"

#include "HangingMeshes.h"
#include "MeshLattice.h"
#include "TestMeshes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace
{
using namespace SortMeshes;

// What random meshes came down to: from the diagonal eye what fills the gap runs in a circle, of
// which the two cells are no part.
Grid TwoTetrahedra()
{
  static const double points[8][3] = { { 0.555833100304992, 0.55214333618409561,
                                         0.46236086750525612 },
    { 0.66189135321380255, 0.32264860150094793, 0.024511451685760324 },
    { 0.45818458167457937, 0.67383467523718121, 0.14784469099683623 },
    { 0.70199214011154987, 0.79680498300035263, 0.12274202032146471 },
    { 0.41609964254740872, 0.25138818157746196, 0.94625416244476956 },
    { 0.46391064583772595, 0.38548435077602627, 0.40750737070544557 },
    { 0.82160469362321542, 0.30594132474009744, 0.74537514229362656 },
    { 0.28514956268311142, 0.00085248051322851554, 0.43461183747395465 } };
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (const auto& p : points)
  {
    coordinates->InsertNextPoint(p);
  }
  auto grid = Grid::New();
  grid->SetPoints(coordinates);
  const vtkIdType ids[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  grid->InsertNextCell(VTK_TETRA, 4, ids);
  grid->InsertNextCell(VTK_TETRA, 4, ids + 4);
  return grid;
}

Grid SmallOctree()
{
  return HangingMeshes::MakeOctree(4,
    [](const std::array<double, 3>& middle, int size)
    { return middle[0] + middle[1] + middle[2] < 3.5 * size; });
}

std::vector<Entry> MakeGood()
{
  return {
    { "lattice", [] { return Lattice(4); }, false, true },
    { "latticeKuhn", [] { return Kuhn(Lattice(4)); }, false, true },
    { "latticeKuhnShuffled", [] { return Shuffled(Kuhn(Lattice(4)), 3); }, false, true },
    { "latticeKuhnJittered", [] { return Kuhn(JitteredLattice(4, 0.15)); }, true, true },
    { "latticeJittered", [] { return JitteredLattice(4, 0.1); }, true, true },
    { "latticeFloat", [] { return AsFloat(Kuhn(JitteredLattice(3, 0.15))); }, true, true },
    { "curvilinear", [] { return TestMeshes::Curvilinear(5); }, true, false },
    { "delaunay", [] { return TestMeshes::Delaunay(80); } },
    { "pyramids", [] { return TestMeshes::Cube(VTK_PYRAMID); }, false, true },
    { "voxel", [] { return TestMeshes::Cube(VTK_VOXEL); }, false, true },
    { "lShape", [] { return LShape(); } },
    { "lShapeWedges", [] { return Wedges(LShape()); } },
    { "lShapeKuhn", [] { return Kuhn(LShape()); } },
    { "slabs", [] { return Slabs(); } },
    { "slabsTetrahedra", [] { return Tetrahedra(Slabs()); } },
    { "checkerboard", [] { return Checkerboard(); } },
    { "checkerboardKuhn", [] { return Kuhn(Checkerboard()); } },
    { "checkerboardShuffled", [] { return Shuffled(Checkerboard(), 5); } },
    { "gears", [] { return Gears(); } },
    { "gearsWedges", [] { return Wedges(Gears()); } },
    { "gearsTetrahedra", [] { return Tetrahedra(Gears()); } },
    { "gearsShuffled", [] { return Shuffled(Tetrahedra(Gears()), 9); } },
    { "gearsFloat", [] { return AsFloat(Tetrahedra(Gears())); } },
    { "gearsFar", [] { return Moved(Tetrahedra(Gears()), 1e7, -2e7, 1.5e7); } },
    { "gearsTiny", [] { return Scaled(Tetrahedra(Gears()), 1e-7, 1e-7, 1e-7); } },
    // Flat faces, but for rounding, and many of them seen edge-on.
    { "torus", [] { return Torus(); } },
    { "torusTetrahedra", [] { return Tetrahedra(Torus()); } },
    { "hollowSphere", [] { return HollowSphere(); }, true },
    { "hollowSphereTetrahedra", [] { return Tetrahedra(HollowSphere()); } },
    { "spring", [] { return Spring(); }, true },
    { "springTetrahedra", [] { return Tetrahedra(Spring()); } },
    { "twoTetrahedra", TwoTetrahedra },
    { "prisms", [] { return Prisms(); } },
    // Polyhedra with nodes in a row on their edges, as they are and as tetrahedra.
    { "hangingOctree", [] { return SmallOctree(); }, false, true },
    { "hangingNodes", [] { return Tetrahedra(HangingMeshes::MakeBoxes(2)); }, false, true },
    { "slivers", [] { return Scaled(Kuhn(JitteredLattice(4, 0.15)), 1.0, 1.0, 1e-6); }, true,
      true },
    { "sliversL", [] { return Scaled(Kuhn(LShape()), 1e-6, 1.0, 1.0); } },
    { "sliversGears", [] { return Scaled(Gears(), 1.0, 1e-6, 1.0); } },
    { "latticeFar", [] { return Moved(Kuhn(Lattice(4)), 1e7, 1e7, 1e7); }, false, true },
    { "latticeTiny", [] { return Scaled(Kuhn(Lattice(4)), 1e-7, 1e-7, 1e-7); }, true, true },
    { "warpedThree", [] { return WarpedThree(); }, true },
    { "bars", [] { return Bars(3, 2.2); }, true, false, true },
    { "barsTetrahedra", [] { return Tetrahedra(Bars(3, 2.2)); }, true, false, true },
    { "slantedGear", [] { return SlantedGear(); }, true, false, true },
    { "slantedGearTetrahedra", [] { return Tetrahedra(SlantedGear()); }, true, false, true },
  };
}

//------------------------------------------------------------------------------
// A second mesh within the first.
Grid Overlapping()
{
  return Join(Lattice(2), Moved(Lattice(2), 0.06, 0.07, 0.05));
}

// Three wedges that share one face.
Grid ThreeOnOneFace()
{
  Grid grid = Kuhn(MeshLattice(1, 1, 1).Make());
  const double apex[3] = { 0.9, 0.1, 0.2 };
  const vtkIdType corners[4] = { 0, 2, 6, grid->GetPoints()->InsertNextPoint(apex) };
  grid->InsertNextCell(VTK_TETRA, 4, corners);
  return grid;
}

// A large cube beside four small ones: points of one in the middle of the other's face.
Grid TJunctions()
{
  return Join(
    Scaled(MeshLattice(1, 1, 1).Make(), 2, 2, 2), Moved(MeshLattice(1, 2, 2).Make(), 2, 0, 0));
}

Grid MissingCell()
{
  return Select(Kuhn(Lattice(3)), [](vtkIdType cell) { return cell % 29 != 13; });
}

// Every second cell turned inside out.
Grid WrongWinding()
{
  Grid grid = Kuhn(LShape());
  auto turned = Grid::New();
  turned->SetPoints(grid->GetPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    const vtkIdType first = ids->GetId(0), second = ids->GetId(1);
    ids->SetId(0, cell % 2 ? second : first);
    ids->SetId(1, cell % 2 ? first : second);
    turned->InsertNextCell(VTK_TETRA, ids);
  }
  return turned;
}

Grid Duplicates()
{
  Grid grid = Kuhn(Lattice(2));
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : { 3, 17, 40 })
  {
    grid->GetCellPoints(cell, ids);
    grid->InsertNextCell(VTK_TETRA, ids);
  }
  return grid;
}

std::vector<Entry> MakeBad()
{
  return {
    { "overlapping", Overlapping },
    { "threeOnOneFace", ThreeOnOneFace },
    { "tJunctions", TJunctions },
    { "duplicates", Duplicates },
    // These two are no fault: a hole is filled, and no sort trusts the winding.
    { "missingCell", MissingCell },
    { "wrongWinding", WrongWinding },
  };
}
}

//------------------------------------------------------------------------------
const std::vector<Entry>& SortMeshes::All()
{
  static const std::vector<Entry> entries = MakeGood();
  return entries;
}

//------------------------------------------------------------------------------
const std::vector<Entry>& SortMeshes::Bad()
{
  static const std::vector<Entry> entries = MakeBad();
  return entries;
}

//------------------------------------------------------------------------------
Grid SortMeshes::Make(const std::string& name)
{
  for (const auto* entries : { &All(), &Bad() })
  {
    for (const Entry& entry : *entries)
    {
      if (entry.Name == name)
      {
        Grid grid = entry.Make();
        AddScalar(grid);
        return grid;
      }
    }
  }
  return nullptr;
}
