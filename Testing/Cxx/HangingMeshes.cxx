#include "HangingMeshes.h"

#include "ConvexCellsTesting.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace
{
using namespace ConvexCellsTesting;
using HangingMeshes::Grid;
using HangingMeshes::IsFine;
using Node = std::array<int, 3>;

/** Polyhedra, one a leaf. */
class Octree
{
public:
  Octree(int size, const IsFine& isFine)
    : IsCut(isFine)
  {
    this->AddLeaves({ 0, 0, 0 }, size);
    std::vector<Point> points;
    for (auto& node : this->Nodes)
    {
      node.second = static_cast<vtkIdType>(points.size());
      points.push_back({ double(node.first[0]), double(node.first[1]), double(node.first[2]) });
    }
    this->Output = MakeGrid(points);
    for (const auto& leaf : this->Leaves)
    {
      this->AddCell(leaf.first, leaf.second);
    }
  }

  Grid Output;

private:
  void AddLeaves(const Node& corner, int size);
  void AddCell(const Node& corner, int size);
  void AddEdge(const Node& a, const Node& b, std::vector<vtkIdType>& face) const;
  void AddSide(const Node& corner, int size, int u, int v, Faces& faces) const;

  const IsFine& IsCut;
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
  const Point middle = { corner[0] + 0.5 * size, corner[1] + 0.5 * size, corner[2] + 0.5 * size };
  const bool isCut = half > 0 && this->IsCut(middle, size);
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
  AddPolyhedron(this->Output, faces);
}

// The side of a box of `size` across `axis`, `at` 0 or 1, with all nodes on its edges, outward.
std::vector<vtkIdType> Outline(
  std::map<Node, vtkIdType>& nodes, const Node& box, int size, int axis, int at)
{
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<vtkIdType> face;
  Node node = Moved(box, axis, at * size);
  for (int edge = 0; edge < 4; ++edge)
  {
    for (int step = 0; step < size; ++step)
    {
      face.push_back(nodes.emplace(node, static_cast<vtkIdType>(nodes.size())).first->second);
      node = Moved(node, edge % 2 ? v : u, edge < 2 ? 1 : -1);
    }
  }
  if (at == 0)
  {
    std::reverse(face.begin(), face.end());
  }
  return face;
}
}

Grid HangingMeshes::MakeOctree(int size, const IsFine& isFine)
{
  return Octree(size, isFine).Output;
}

Grid HangingMeshes::MakeRings()
{
  const auto distance = [](const Point& x)
  {
    const double first = std::hypot(std::hypot(x[0] - 11.0, x[1] - 16.0) - 8.0, x[2] - 16.0);
    const double second = std::hypot(std::hypot(x[0] - 21.0, x[2] - 16.0) - 8.0, x[1] - 16.0);
    return std::min(first, second);
  };
  return MakeOctree(32,
    [&](const Point& middle, int size)
    { return size > 4 || (size > 1 && distance(middle) < size + 1.0); });
}

Grid HangingMeshes::MakeBoxes(int hanging)
{
  const int size = hanging + 1;
  std::map<Node, vtkIdType> nodes;
  std::vector<Faces> cells(8);
  for (int cell = 0; cell < 8; ++cell)
  {
    const Node box = { cell % 2 * size, cell / 2 % 2 * size, cell / 4 * size };
    for (int side = 0; side < 6; ++side)
    {
      cells[cell].push_back(Outline(nodes, box, size, side / 2, side % 2));
    }
  }
  std::vector<Point> points(nodes.size());
  for (const auto& node : nodes)
  {
    const Node& at = node.first;
    points[node.second] = { double(at[0]) / size, double(at[1]) / size, double(at[2]) / size };
  }
  Grid grid = MakeGrid(points);
  for (const Faces& faces : cells)
  {
    AddPolyhedron(grid, faces);
  }
  return grid;
}
