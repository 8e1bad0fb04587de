// A linear field over cells of any type, fed directly: every mapper draws the image of the
// tetrahedra that VTK cuts the cell into. (Side by side those of VTK do not meet, and then no order
// is right: there the tetrahedra are ours.)
#include "CellZoo.h"
#include "ConvexCellsTesting.h"
#include "HangingMeshes.h"
#undef CHECK
#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include "vtkBarycentricShellMapper.h"
#include "vtkConvexCells.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkPointData.h"

#include <numeric>

namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

struct Mesh
{
  std::string Name;
  Grid Cells;
};

Grid Polyhedron()
{
  auto grid = ConvexCellsTesting::MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { .2, .1, 1 }, { .8, .1, 1 }, { .8, .7, 1 }, { .2, .7, 1 } });
  ConvexCellsTesting::AddPolyhedron(grid, ConvexCellsTesting::BoxFaces({ 0, 1, 2, 3, 4, 5, 6, 7 }));
  return grid;
}

// Into the unit cube about the origin, with a scalar that is linear and within 0 .. 1.
void Settle(vtkUnstructuredGrid* grid)
{
  double bounds[6];
  grid->GetBounds(bounds);
  const double size =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double x[3];
    grid->GetPoint(id, x);
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = (x[axis] - 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1])) / size;
    }
    grid->GetPoints()->SetPoint(id, x);
  }
  TestMeshes::SetField(
    grid, [](const double* x) { return 0.5 + 0.4 * x[0] - 0.25 * x[1] + 0.3 * x[2]; });
}

// Polyhedra with nodes in the middle of edges; turned in floats, so that rounding bends faces, some
// go out as tetrahedra, whose faces are cut otherwise than those of the whole cells beside them.
Grid Octree(bool isTurned)
{
  auto grid = HangingMeshes::MakeOctree(4, [](const std::array<double, 3>& middle, int size)
    { return middle[0] + middle[1] + middle[2] < 3.5 * size; });
  vtkNew<vtkPoints> turned;
  turned->SetDataType(isTurned ? VTK_FLOAT : VTK_DOUBLE);
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    const double* p = grid->GetPoint(id);
    const double along[3] = { .48 * p[0] - .6 * p[1] + .64 * p[2],
      .36 * p[0] + .8 * p[1] + .48 * p[2], -.8 * p[0] + .6 * p[2] };
    turned->InsertNextPoint(isTurned ? along : p);
  }
  grid->SetPoints(turned);
  return grid;
}

// One cell of each type as VTK has it, octrees, and a block of all kinds side by side.
std::vector<Mesh> Meshes()
{
  std::vector<Mesh> meshes = { { "polyhedron", Polyhedron() }, { "octree", Octree(false) },
    { "turned octree", Octree(true) } };
  for (const int hanging : { 1, 2, 3 })
  {
    meshes.push_back(
      { std::to_string(hanging) + " nodes on each edge", HangingMeshes::MakeBoxes(hanging) });
  }
  for (const int type : CellZoo::AllTypes())
  {
    meshes.push_back({ "type " + std::to_string(type), CellZoo::Reference(type) });
  }
  const int size[3] = { 3, 3, 3 };
  std::vector<int> kinds(27);
  std::iota(kinds.begin(), kinds.end(), 0);
  std::transform(kinds.begin(), kinds.end(), kinds.begin(),
    [](int cube) { return 7 * cube % CellZoo::NumberOfKinds; });
  meshes.push_back({ "all kinds", CellZoo::Make(size, kinds, [](const double*) { return 0.0; }) });
  for (const Mesh& mesh : meshes)
  {
    Settle(mesh.Cells);
  }
  return meshes;
}

std::vector<PolyhedraMappers::Entry> Mappers()
{
  std::vector<PolyhedraMappers::Entry> mappers = PolyhedraMappers::All();
  for (const int engine : { vtkConvexCellMapper::RASTER, vtkConvexCellMapper::TILES })
  {
    mappers.push_back({ engine == vtkConvexCellMapper::RASTER ? "tetrahedra, Raster"
                                                              : "tetrahedra, Tiles",
      [engine]
      {
        auto mapper = vtkSmartPointer<vtkPreIntegratedTetrahedraMapper>::New();
        mapper->SetEngine(engine);
        return mapper;
      },
      false });
  }
  mappers.push_back(
    { "shells", [] { return vtkSmartPointer<vtkBarycentricShellMapper>::New(); }, false });
  return mappers;
}

Grid Tetrahedra(vtkUnstructuredGrid* grid)
{
  const bool isOne = grid->GetNumberOfCells() == 1;
  vtkNew<vtkDataSetTriangleFilter> theirs;
  vtkNew<vtkConvexCells> ours;
  theirs->TetrahedraOnlyOn();
  ours->TetrahedraOnlyOn();
  vtkAlgorithm* cut = isOne ? static_cast<vtkAlgorithm*>(theirs) : ours;
  cut->SetInputDataObject(grid);
  cut->Update();
  return vtkUnstructuredGrid::SafeDownCast(cut->GetOutputDataObject(0));
}

vtkSmartPointer<vtkImageData> Draw(PolyhedraScene& scene, vtkUnstructuredGrid* grid)
{
  scene.Mapper->SetInputData(grid);
  scene.Render();
  return scene.CopyCaptured();
}

void CheckMapper(
  TestChecks& checks, const PolyhedraMappers::Entry& mapper, const std::vector<Mesh>& meshes)
{
  PolyhedraScene scene(mapper.Make(), 64, 64);
  if (mapper.ThreePasses)
  {
    scene.SetLinearEmission();
  }
  double largest = 0.0;
  for (const Mesh& mesh : meshes)
  {
    auto tetrahedra = Draw(scene, Tetrahedra(mesh.Cells));
    const int lit = scene.CountLitPixels();
    auto cells = Draw(scene, mesh.Cells);
    const double difference = TestScene::Difference(tetrahedra, cells);
    const std::string name = mapper.Name + ", " + mesh.Name;
    checks.Check(lit > 100, name.c_str(), __LINE__, std::to_string(lit) + " pixels");
    checks.Check(difference >= 0.0 && difference <= 1e-4, name.c_str(), __LINE__,
      std::to_string(difference));
    largest = std::max(largest, difference);
  }
  std::cout << mapper.Name << ": largest difference " << largest << "\n";
}
}

int TestLinearFields(int, char*[])
{
  TestChecks checks;
  const std::vector<Mesh> meshes = Meshes();
  for (const PolyhedraMappers::Entry& mapper : Mappers())
  {
    CheckMapper(checks, mapper, meshes);
  }
  return checks.Result();
}
