// Hanging nodes: an octree as polyhedra, whose large cells have the nodes and faces of the small
// ones beside them; boxes with several nodes on each edge; the polyhedra and prisms of real files.
// Volumes stay. Of tetrahedra every inner face is matched by exactly one other. Of convex cells the
// faces that have no other are as large as the surface; not tested where tetrahedra are among them.
#include "CellZoo.h"
#include "ConvexCellsTesting.h"
#include "HangingMeshes.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <fstream>
#include <numeric>
#include <random>
#include <string>

namespace
{
using namespace ConvexCellsTesting;

struct Case
{
  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  double Volume;
  double Area;
  bool Hangs;
  std::string Name;
};

double Linear(const Point& x)
{
  return 1.0 + x[0] - 2.0 * x[1] + 0.5 * x[2];
}
// Each point of the output, but those within cells.
void CheckScalars(vtkUnstructuredGrid* output)
{
  vtkDataArray* made = output->GetPointData()->GetScalars();
  for (vtkIdType id = 0; CHECK(made) && id < output->GetNumberOfPoints(); ++id)
  {
    const Point x = PointOf(output, id);
    CHECK(std::abs(made->GetTuple1(id) - Linear(x)) < 1e-5);
  }
}

// Three nodes in a row on an edge are a triangle without an area in the fans by which whole cells are
// counted, and another cut of the face where rounding made one of its two cells tetrahedra.
void CheckMatched(const Case& mesh, double relative)
{
  for (const bool tetrahedraOnly : { false, true })
  {
    auto filter = Run(mesh.Mesh, tetrahedraOnly);
    vtkUnstructuredGrid* output = filter->GetOutput();
    const CellZoo::FaceUses uses = CellZoo::CountFaceUses(output);
    const double volume = tetrahedraOnly ? TotalVolume(output) : VolumeWithin(output);
    const bool isMixed = CountType(output, VTK_TETRA) < output->GetNumberOfCells() &&
                         CountType(output, VTK_TETRA) > 0;
    const bool good = CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0) &&
                      CHECK_EQUAL(filter->GetNumberOfFoldedCells(), 0) &&
                      CHECK(!mesh.Hangs || filter->GetNumberOfDroppedTetrahedra() == 0) &&
                      CHECK((mesh.Hangs && !tetrahedraOnly) || uses.More == 0) &&
                      CHECK((mesh.Hangs && isMixed) || Near(uses.AreaOfOnce, mesh.Area, relative)) &&
                      CHECK(Near(volume, mesh.Volume, relative));
    std::cout << mesh.Name << (tetrahedraOnly ? ", tetrahedra: " : ", convex cells: ")
              << mesh.Mesh->GetNumberOfCells() << " in, " << output->GetNumberOfCells() << " out, "
              << output->GetNumberOfPoints() - mesh.Mesh->GetNumberOfPoints()
              << " points added, area off by " << uses.AreaOfOnce / mesh.Area - 1.0
              << ", volume by " << volume / mesh.Volume - 1.0 << (good ? "\n" : ": wrong\n");
    if (mesh.Hangs)
    {
      CheckScalars(output);
    }
  }
}

// With other ids, turned so that rounding bends edges and faces, in either precision. Seed 0: as it
// is.
vtkSmartPointer<vtkUnstructuredGrid> Changed(
  vtkUnstructuredGrid* grid, unsigned int seed, int precision)
{
  std::vector<vtkIdType> names(grid->GetNumberOfPoints());
  std::iota(names.begin(), names.end(), vtkIdType{ 0 });
  std::mt19937 random(seed);
  if (seed > 0)
  {
    std::shuffle(names.begin(), names.end(), random);
  }
  std::vector<Point> points(names.size());
  for (std::size_t id = 0; id < names.size(); ++id)
  {
    const Point p = PointOf(grid, static_cast<vtkIdType>(id));
    points[names[id]] = seed == 0 ? p
                                  : Point{ 1.3 + .48 * p[0] - .6 * p[1] + .64 * p[2],
                                      .36 * p[0] + .8 * p[1] + .48 * p[2] + .1,
                                      -.8 * p[0] + .6 * p[2] - .7 };
  }
  auto changed = MakeGrid(points, precision);
  vtkNew<vtkIdList> stream;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetFaceStream(cell, stream);
    Faces faces;
    for (vtkIdType at = 1; at < stream->GetNumberOfIds(); at += 1 + stream->GetId(at))
    {
      faces.emplace_back();
      for (vtkIdType i = 1; i <= stream->GetId(at); ++i)
      {
        faces.back().push_back(names[stream->GetId(at + i)]);
      }
    }
    AddPolyhedron(changed, faces);
  }
  vtkNew<vtkDoubleArray> scalar;
  for (vtkIdType id = 0; id < changed->GetNumberOfPoints(); ++id)
  {
    scalar->InsertNextValue(Linear(PointOf(changed, id)));
  }
  changed->GetPointData()->SetScalars(scalar);
  return changed;
}

// A cube of `size`, cut up.
void CheckCube(vtkUnstructuredGrid* grid, int size, const std::string& name)
{
  const double volume = double(size) * size * size, area = 6.0 * size * size;
  for (const unsigned int seed : { 0, 1, 2, 3 })
  {
    CheckMatched({ Changed(grid, seed, VTK_DOUBLE), volume, area, true, name }, 1e-10);
    CheckMatched({ Changed(grid, seed, VTK_FLOAT), volume, area, true, name + ", floats" }, 1e-6);
  }
}

// By what goes in, read by VTK's own faces.
void CheckFile(vtkUnstructuredGrid* grid, const char* name)
{
  double volume = 0.0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    volume += std::abs(VolumeWithin(grid->GetCell(cell)));
  }
  CheckMatched({ grid, volume, CellZoo::CountFaceUses(grid).AreaOfOnce, false, name }, 1e-10);
}

std::string FileOf(const char* name)
{
  const char* folder = std::getenv("CELLPROJECTION_DATA");
  const std::string file = std::string(folder ? folder : ".") + "/" + name;
  const bool isThere = static_cast<bool>(std::ifstream(file));
  std::cout << (isThere ? "" : std::string("skipped: no ") + name + "\n");
  return isThere ? file : "";
}
}

int TestConvexCellsHanging(int, char*[])
{
  auto octree = HangingMeshes::MakeOctree(8,
    [](const Point& middle, int size)
    { return middle[0] + middle[1] + middle[2] < 3.5 * size; });
  CHECK(octree->GetNumberOfCells() > 30);
  CheckCube(octree, 8, "octree");
  CheckCube(HangingMeshes::MakeRings(), 32, "rings");
  for (const int hanging : { 0, 1, 2, 3 })
  {
    CheckCube(HangingMeshes::MakeBoxes(hanging), 2, std::to_string(hanging) + " on each edge");
  }
  const std::string prisms = FileOf("PentaHexa.vtk"), polyhedra = FileOf("polyhedron2pieces.vtu");
  if (!prisms.empty())
  {
    vtkNew<vtkUnstructuredGridReader> reader;
    reader->SetFileName(prisms.c_str());
    reader->Update();
    CheckFile(reader->GetOutput(), "PentaHexa");
  }
  if (!polyhedra.empty())
  {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(polyhedra.c_str());
    reader->Update();
    CheckFile(reader->GetOutput(), "polyhedron2pieces");
  }
  return Result();
}
