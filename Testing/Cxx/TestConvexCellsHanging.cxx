// Hanging nodes: an octree as polyhedra, whose large cells have the nodes and faces of the small
// ones beside them; and the polyhedra and prisms of real files. Volumes stay, and every inner face is
// matched; of the octree's tetrahedra not, where a flat one was dropped: as vtkConvexCells says.
#include "CellZoo.h"
#include "ConvexCellsTesting.h"

#include "vtkUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <fstream>
#include <map>
#include <string>

namespace
{
using namespace ConvexCellsTesting;
using Node = std::array<int, 3>;

constexpr int Size = 8;

/** The octree of a cube of Size, finest at its first corner. */
class Octree
{
public:
  Octree()
  {
    this->AddLeaves({ 0, 0, 0 }, Size);
    std::vector<Point> points;
    for (auto& node : this->Nodes)
    {
      node.second = static_cast<vtkIdType>(points.size());
      points.push_back({ double(node.first[0]), double(node.first[1]), double(node.first[2]) });
    }
    this->Grid = MakeGrid(points);
    for (const auto& leaf : this->Leaves)
    {
      this->AddCell(leaf.first, leaf.second);
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> Grid;

private:
  void AddLeaves(const Node& corner, int size);
  void AddCell(const Node& corner, int size);
  void AddEdge(const Node& a, const Node& b, std::vector<vtkIdType>& face) const;
  void AddSide(const Node& corner, int size, int u, int v, Faces& faces) const;

  std::vector<std::pair<Node, int>> Leaves;
  std::map<Node, vtkIdType> Nodes;
};

Node Moved(Node node, int axis, int by)
{
  node[axis] += by;
  return node;
}

void Octree::AddLeaves(const Node& corner, int size)
{
  const int half = size / 2;
  const bool isCut = half > 0 && corner[0] + corner[1] + corner[2] < 2 * size;
  for (int child = 0; child < 8; ++child)
  {
    const int step = isCut ? half : size;
    Node at = corner;
    for (int axis = 0; axis < 3; ++axis)
    {
      at = Moved(at, axis, (child >> axis & 1) * step);
    }
    if (isCut)
    {
      this->AddLeaves(at, half);
    }
    else
    {
      this->Nodes[at] = 0;
    }
  }
  if (!isCut)
  {
    this->Leaves.emplace_back(corner, size);
  }
}

// From a on, with what hangs on the edge, without b.
void Octree::AddEdge(const Node& a, const Node& b, std::vector<vtkIdType>& face) const
{
  const Node middle = { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 };
  if (middle == a || middle == b || this->Nodes.count(middle) == 0)
  {
    face.push_back(this->Nodes.at(a));
    return;
  }
  this->AddEdge(a, middle, face);
  this->AddEdge(middle, b, face);
}

void Octree::AddSide(const Node& corner, int size, int u, int v, Faces& faces) const
{
  const int half = size / 2;
  if (half > 0 && this->Nodes.count(Moved(Moved(corner, u, half), v, half)) > 0)
  {
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      const Node at = Moved(Moved(corner, u, quarter % 2 * half), v, quarter / 2 * half);
      this->AddSide(at, half, u, v, faces);
    }
    return;
  }
  const Node right = Moved(corner, u, size), top = Moved(corner, v, size);
  const Node across = Moved(right, v, size);
  faces.emplace_back();
  this->AddEdge(corner, right, faces.back());
  this->AddEdge(right, across, faces.back());
  this->AddEdge(across, top, faces.back());
  this->AddEdge(top, corner, faces.back());
}

void Octree::AddCell(const Node& corner, int size)
{
  Faces faces;
  for (int side = 0; side < 6; ++side)
  {
    const int axis = side / 2;
    const Node at = Moved(corner, axis, side % 2 * size);
    this->AddSide(at, size, (axis + 1) % 3, (axis + 2) % 3, faces);
  }
  AddPolyhedron(this->Grid, faces);
}

void CheckMatched(
  vtkUnstructuredGrid* grid, double volume, double area, bool hangs, const char* name)
{
  for (const bool tetrahedraOnly : { false, true })
  {
    auto filter = Run(grid, tetrahedraOnly);
    vtkUnstructuredGrid* output = filter->GetOutput();
    const CellZoo::FaceUses uses = CellZoo::CountFaceUses(output);
    // Three nodes in a row on an edge are a triangle without an area, of any cell there.
    const bool good = CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0) &&
                      CHECK((hangs && !tetrahedraOnly) || uses.More == 0) &&
                      CHECK((hangs && tetrahedraOnly) || Near(uses.AreaOfOnce, area, 1e-10)) &&
                      CHECK(Near(VolumeWithin(output), volume, 1e-10));
    std::cout << name << (tetrahedraOnly ? ", tetrahedra: " : ", convex cells: ")
              << grid->GetNumberOfCells() << " in, " << output->GetNumberOfCells() << " out, area "
              << uses.AreaOfOnce << " for " << area << ", volume " << VolumeWithin(output)
              << " for " << volume << (good ? "\n" : ": wrong\n");
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
  CheckMatched(grid, volume, CellZoo::CountFaceUses(grid).AreaOfOnce, false, name);
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
  const Octree octree;
  CHECK(octree.Grid->GetNumberOfCells() > 30);
  CheckMatched(octree.Grid, double(Size) * Size * Size, 6.0 * Size * Size, true, "octree");
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
