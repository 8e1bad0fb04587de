#include "CellSpoiler.h"

#include "CellZoo.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace
{
using namespace ConvexCellsTesting;
using CellZoo::Grid;
using Cell = CellSpoiler::Cell;
using Ids = std::vector<vtkIdType>;
}

// Of a wedge, a hexahedron or a prism of five or six corners, or a hexahedron of triangles.
Cell CellSpoiler::MakePolyhedron()
{
  Cell cell;
  const int count = 3 + static_cast<int>(this->Index(4));
  Faces ends(2);
  for (int i = 0; i < 2 * count; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / count;
    cell.Points.push_back({ std::cos(angle), std::sin(angle), i < count ? 0.0 : 1.0 });
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType next = (i + 1) % count;
    ends[0].insert(ends[0].begin(), i);
    ends[1].push_back(i + count);
    if (this->Index(3) > 0)
    {
      cell.Sides.push_back({ i, next, next + count, i + count });
      continue;
    }
    cell.Sides.push_back({ i, next, next + count });
    cell.Sides.push_back({ i, next + count, i + count });
  }
  cell.Sides.insert(cell.Sides.end(), ends.begin(), ends.end());
  return cell;
}

// Nodes on the straight edge from the smaller id to the larger, two at most.
Ids CellSpoiler::HangNodes(Cell& cell, const Edge& edge, std::size_t rarity)
{
  Ids nodes;
  const std::size_t count = this->Index(rarity) == 0 ? 1 + this->Index(2) : 0;
  const Point from = cell.Points[edge[0]], along = Minus(cell.Points[edge[1]], from);
  for (std::size_t node = 1; node <= count; ++node)
  {
    const double share = double(node) / (count + 1);
    nodes.push_back(static_cast<vtkIdType>(cell.Points.size()));
    cell.Points.push_back(
      { from[0] + share * along[0], from[1] + share * along[1], from[2] + share * along[2] });
  }
  return nodes;
}

// In every side that has the edge; then ids in any order.
void CellSpoiler::Hang(Cell& cell)
{
  std::map<Edge, Ids> hanging;
  const std::size_t rarity = 1 + this->Index(3);
  Faces sides;
  for (const Ids& side : cell.Sides)
  {
    Ids all;
    for (std::size_t i = 0; i < side.size(); ++i)
    {
      const vtkIdType a = side[i], b = side[(i + 1) % side.size()];
      const Edge edge = { std::min(a, b), std::max(a, b) };
      if (hanging.count(edge) == 0)
      {
        hanging[edge] = this->HangNodes(cell, edge, rarity);
      }
      const Ids& nodes = hanging[edge];
      all.push_back(a);
      a < b ? all.insert(all.end(), nodes.begin(), nodes.end())
            : all.insert(all.end(), nodes.rbegin(), nodes.rend());
    }
    sides.push_back(all);
  }
  cell.Sides = sides;
  this->Renumber(cell);
}

void CellSpoiler::Renumber(Cell& cell)
{
  Ids names(cell.Points.size());
  std::iota(names.begin(), names.end(), vtkIdType{ 0 });
  std::shuffle(names.begin(), names.end(), this->Random);
  const std::vector<Point> points = cell.Points;
  for (std::size_t id = 0; id < names.size(); ++id)
  {
    cell.Points[names[id]] = points[id];
  }
  for (Ids& side : cell.Sides)
  {
    std::transform(side.begin(), side.end(), side.begin(), [&](vtkIdType id) { return names[id]; });
  }
}

// Turned, stretched, moved, and bent a little or a lot.
void CellSpoiler::Place(Cell& cell)
{
  const double bend = this->Index(3) == 0 ? 0.4 : this->Index(2) == 0 ? 0.05 : 0.0;
  const Point origin = { this->Number(-1, 1), this->Number(-1, 1), this->Number(-1, 1) };
  double matrix[3][3];
  for (auto& row : matrix)
  {
    std::generate(row, row + 3, [this] { return this->Number(-1.0, 1.0); });
  }
  for (Point& x : cell.Points)
  {
    const Point old = x;
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = origin[axis] + this->Number(-bend, bend) + matrix[axis][0] * old[0] +
                matrix[axis][1] * old[1] + matrix[axis][2] * old[2];
    }
  }
}

// What makes coordinates degenerate.
void CellSpoiler::SpoilPoints(Cell& cell)
{
  const std::size_t count = cell.Points.size(), axis = this->Index(3);
  Point& chosen = cell.Points[this->Index(count)];
  switch (this->Index(8))
  {
    case 0: // coincident
      chosen = cell.Points[this->Index(count)];
      break;
    case 1: // touches itself
    {
      const Point &a = cell.Points[this->Index(count)], &b = cell.Points[this->Index(count)],
                  &c = cell.Points[this->Index(count)];
      const double u = this->Number(0, 1), v = this->Index(2) ? 0.0 : this->Number(0, 1 - u);
      chosen = { a[0] + u * (b[0] - a[0]) + v * (c[0] - a[0]),
        a[1] + u * (b[1] - a[1]) + v * (c[1] - a[1]),
        a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]) };
      break;
    }
    case 2: // flat or thin
    {
      const double thickness = std::array<double, 4>{ 0.0, 1e-15, 1e-12, 1e-6 }[this->Index(4)];
      for (Point& x : cell.Points)
      {
        x[axis] = 0.3 * x[(axis + 1) % 3] + thickness * x[axis];
      }
      break;
    }
    case 3: // on a lattice
      for (Point& x : cell.Points)
      {
        std::transform(x.begin(), x.end(), x.begin(), [](double y) { return std::round(2.0 * y); });
      }
      break;
    case 4: // not finite
      chosen[axis] = this->Index(2) ? std::nan("") : std::numeric_limits<double>::infinity();
      break;
    case 5: // huge or tiny
    {
      const double scale = std::pow(10.0, this->Number(-160, 100));
      for (Point& x : cell.Points)
      {
        std::transform(x.begin(), x.end(), x.begin(), [=](double y) { return scale * y; });
      }
      break;
    }
    case 6: // far away
      for (Point& x : cell.Points)
      {
        x[axis] += 1e7;
      }
      break;
    default: // a line, or a point
      for (Point& x : cell.Points)
      {
        x[axis] = x[(axis + 1) % 3] = this->Index(4) == 0 ? 1.0 : x[(axis + 2) % 3];
      }
  }
}

// What turns a cell over, and tangles it.
void CellSpoiler::SpoilShape(Cell& cell)
{
  const std::size_t count = cell.Points.size();
  switch (this->Index(4))
  {
    case 0:
      for (Point& x : cell.Points)
      {
        x[2] = -x[2];
      }
      break;
    case 1:
      std::swap(cell.Points[this->Index(count)], cell.Points[this->Index(count)]);
      break;
    case 2:
      std::shuffle(cell.Points.begin(), cell.Points.end(), this->Random);
      break;
    default: // through the other side
    {
      Point& x = cell.Points[this->Index(count)];
      const Point& across = cell.Points[this->Index(count)];
      const double far = this->Number(0.5, 2.0);
      for (int axis = 0; axis < 3; ++axis)
      {
        x[axis] += far * (across[axis] - x[axis]);
      }
    }
  }
}

void CellSpoiler::SpoilLists(Cell& cell)
{
  if (cell.Type == VTK_POLYHEDRON)
  {
    this->SpoilSides(cell);
    return;
  }
  if (cell.Corners.empty())
  {
    return;
  }
  vtkIdType& id = cell.Corners[this->Index(cell.Corners.size())];
  switch (this->Index(6))
  {
    case 0:
      id = this->Index(2) ? -1 : 1000000;
      break;
    case 1:
      cell.Corners.resize(this->Index(cell.Corners.size()));
      break;
    case 2:
      cell.Corners.push_back(0);
      break;
    default:
      id = cell.Corners[this->Index(cell.Corners.size())];
  }
}

void CellSpoiler::SpoilSides(Cell& cell)
{
  Ids& side = cell.Sides[this->Index(cell.Sides.size())];
  vtkIdType& id = side[this->Index(side.size())];
  switch (this->Index(7))
  {
    case 0:
      std::reverse(side.begin(), side.end());
      break;
    case 1:
      side = cell.Sides.back();
      break;
    case 2:
      side.resize(this->Index(side.size()) + 1);
      break;
    case 3:
      id = 1000000;
      break;
    case 4:
      cell.Sides.resize(std::max<std::size_t>(1, cell.Sides.size() - 1));
      break;
    case 5:
      side.push_back(side.back());
      break;
    default:
      id = side[this->Index(side.size())];
  }
}

Cell CellSpoiler::Make(int type)
{
  Cell cell;
  if (type == VTK_POLYHEDRON)
  {
    cell = this->MakePolyhedron();
  }
  else
  {
    Grid reference = CellZoo::Reference(type, 2 + static_cast<int>(this->Index(2)));
    for (vtkIdType id = 0; id < reference->GetNumberOfPoints(); ++id)
    {
      cell.Points.push_back(PointOf(reference, id));
      cell.Corners.push_back(id);
    }
  }
  cell.Type = type;
  this->Place(cell);
  if (type == VTK_POLYHEDRON && this->Index(2) == 0)
  {
    this->Hang(cell);
  }
  for (std::size_t spoilt = this->Index(3); spoilt > 0; --spoilt)
  {
    const std::size_t kind = this->Index(8);
    kind < 4   ? this->SpoilPoints(cell)
    : kind < 7 ? this->SpoilShape(cell)
               : this->SpoilLists(cell);
  }
  return cell;
}
