#include "TetrahedralSplit.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace TetrahedralSplit;

template <int Faces, int Corners>
struct Table
{
  int FaceOffsets[Faces + 1];
  int FaceVertices[Corners];
};

// VTK's wedge has its first triangle facing outward, unlike its tetrahedron.
constexpr Table<4, 12> TetrahedronFaces = { { 0, 3, 6, 9, 12 },
  { 0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 2, 1 } };
constexpr Table<5, 16> PyramidFaces = { { 0, 4, 7, 10, 13, 16 },
  { 0, 3, 2, 1, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4 } };
constexpr Table<5, 18> WedgeFaces = { { 0, 3, 6, 10, 14, 18 },
  { 0, 1, 2, 3, 5, 4, 0, 3, 4, 1, 1, 4, 5, 2, 2, 5, 3, 0 } };
constexpr Table<6, 24> HexahedronFaces = { { 0, 4, 8, 12, 16, 20, 24 },
  { 0, 4, 7, 3, 1, 2, 6, 5, 0, 1, 5, 4, 3, 7, 6, 2, 0, 3, 2, 1, 4, 5, 6, 7 } };
constexpr Table<7, 30> PentagonalPrismFaces = { { 0, 5, 10, 14, 18, 22, 26, 30 },
  { 0, 4, 3, 2, 1, 5, 6, 7, 8, 9, 0, 1, 6, 5, 1, 2, 7, 6, 2, 3, 8, 7, 3, 4, 9, 8, 4, 0, 5, 9 } };
constexpr Table<8, 36> HexagonalPrismFaces = { { 0, 6, 12, 16, 20, 24, 28, 32, 36 },
  { 0, 5, 4, 3, 2, 1, 6, 7, 8, 9, 10, 11, 0, 1, 7, 6, 1, 2, 8, 7, 2, 3, 9, 8, 3, 4, 10, 9, 4, 5, 11,
    10, 5, 0, 6, 11 } };

template <int Faces, int Corners>
constexpr Solid View(int vertices, const Table<Faces, Corners>& table)
{
  return { vertices, Faces, table.FaceOffsets, table.FaceVertices };
}

// By Shape, as all that follow.
constexpr Solid Solids[] = { View(4, TetrahedronFaces), View(5, PyramidFaces), View(6, WedgeFaces),
  View(8, HexahedronFaces), View(10, PentagonalPrismFaces), View(12, HexagonalPrismFaces) };

// The mirror image's numbering.
constexpr unsigned char TurnedOrder[][MaximumVertices] = { { 0, 1, 3, 2 }, { 0, 3, 2, 1, 4 },
  { 3, 4, 5, 0, 1, 2 }, { 4, 5, 6, 7, 0, 1, 2, 3 }, { 5, 6, 7, 8, 9, 0, 1, 2, 3, 4 },
  { 6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 4, 5 } };

// Of a hexahedron's vertex: the one across the cell, and the three next to it, such that vertex and
// neighbours make a positive tetrahedron.
constexpr unsigned char Antipode[8] = { 6, 7, 4, 5, 2, 3, 0, 1 };
constexpr unsigned char Neighbours[8][3] = { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 },
  { 7, 5, 0 }, { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } };

// Positive where abc, seen from a, b, c's far side, turns counter-clockwise.
void AddTetrahedron(Pieces& pieces, int apex, int a, int b, int c)
{
  unsigned char* vertex = pieces.Vertex[pieces.Count++];
  vertex[0] = static_cast<unsigned char>(apex);
  vertex[1] = static_cast<unsigned char>(a);
  vertex[2] = static_cast<unsigned char>(b);
  vertex[3] = static_cast<unsigned char>(c);
}

int SmallestVertex(const Solid& solid, const vtkIdType* ids)
{
  return static_cast<int>(std::min_element(ids, ids + solid.NumberOfVertices) - ids);
}

// Of a hexahedron.
bool DiagonalEndsIn(int vertex, const Solid& solid, const vtkIdType* ids)
{
  bool ends = false;
  for (int face = 0; face < solid.NumberOfFaces && !ends; ++face)
  {
    if (solid.Touches(face, vertex))
    {
      int uses = 0;
      VisitTriangles(solid, face, ids,
        [&](int a, int b, int c) { uses += a == vertex || b == vertex || c == vertex; });
      ends = uses == 2;
    }
  }
  return ends;
}

// |(b - a) x (c - a)|
double Area(const double a[3], const double b[3], const double c[3])
{
  double u[3], v[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    u[axis] = b[axis] - a[axis];
    v[axis] = c[axis] - a[axis];
  }
  const double x = u[1] * v[2] - u[2] * v[1];
  const double y = u[2] * v[0] - u[0] * v[2];
  const double z = u[0] * v[1] - u[1] * v[0];
  return std::sqrt(x * x + y * y + z * z);
}

// `strict`: from its own faces the apex makes no tetrahedra.
bool SeesAll(const Solid& solid, const vtkIdType* ids, const double (*points)[3], double sign,
  int apex, bool strict)
{
  const double flat = FlatnessTolerance * SizeOf(points, solid.NumberOfVertices);
  double seen = 0.0, hidden = 0.0;
  bool all = true;
  VisitCone(solid, ids, apex,
    [&](int face, int a, int b, int c)
    {
      const double volume = sign * SixVolumes(points[apex], points[a], points[b], points[c]);
      const bool behind = volume < 0.0 && -volume > flat * Area(points[a], points[b], points[c]);
      all = all && !behind && !(strict && solid.Touches(face, apex));
      seen += std::max(volume, 0.0);
      hidden += std::max(-volume, 0.0);
    });
  return all && seen > 0.0 && hidden <= FlatnessTolerance * seen;
}
}

namespace TetrahedralSplit
{
const Solid& SolidOf(Shape shape)
{
  return Solids[static_cast<int>(shape)];
}

int NumberOfVertices(Shape shape)
{
  return SolidOf(shape).NumberOfVertices;
}

Pieces Split(Shape shape, const vtkIdType* ids, int chosenApex)
{
  Pieces pieces;
  if (shape == Shape::Tetrahedron)
  {
    AddTetrahedron(pieces, 0, 1, 2, 3);
    return pieces;
  }
  const Solid& solid = SolidOf(shape);
  const int apex = chosenApex < 0 ? SmallestVertex(solid, ids) : chosenApex;
  int corner = -1;
  if (shape == Shape::Hexahedron && chosenApex < 0 && !DiagonalEndsIn(Antipode[apex], solid, ids))
  {
    corner = Antipode[apex];
    const unsigned char* next = Neighbours[corner];
    AddTetrahedron(pieces, corner, next[0], next[1], next[2]);
    AddTetrahedron(pieces, apex, next[0], next[2], next[1]);
  }
  VisitCone(solid, ids, apex,
    [&](int, int a, int b, int c)
    {
      if (a != corner && b != corner && c != corner)
      {
        AddTetrahedron(pieces, apex, a, b, c);
      }
    });
  return pieces;
}

int TurnedVertex(Shape shape, int position)
{
  return TurnedOrder[static_cast<int>(shape)][position];
}

int FindApex(const Solid& solid, const vtkIdType* ids, const double (*points)[3], double sign)
{
  const int smallest = SmallestVertex(solid, ids);
  if (SeesAll(solid, ids, points, sign, smallest, false))
  {
    return smallest;
  }
  for (const bool strict : { true, false })
  {
    for (int apex = 0; apex < solid.NumberOfVertices; ++apex)
    {
      if (SeesAll(solid, ids, points, sign, apex, strict))
      {
        return apex;
      }
    }
  }
  return -1;
}

double SixVolumes(const double a[3], const double b[3], const double c[3], const double d[3])
{
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  const double cxdy = cx * dy, cydx = cy * dx;
  const double dxby = dx * by, dybx = dy * bx;
  const double bxcy = bx * cy, bycx = by * cx;
  const double determinant = bz * (cxdy - cydx) + cz * (dxby - dybx) + dz * (bxcy - bycx);
  const double permanent = std::abs(bz) * (std::abs(cxdy) + std::abs(cydx)) +
                           std::abs(cz) * (std::abs(dxby) + std::abs(dybx)) +
                           std::abs(dz) * (std::abs(bxcy) + std::abs(bycx));
  constexpr double bound = 7.771561172376103e-16; // (7 + 56 e) e with e = 2^-53
  return std::abs(determinant) > bound * permanent ? determinant : 0.0;
}

void ScaleIfExtreme(double (*points)[3], int count)
{
  double largests[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < count; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      largests[axis] = std::max(largests[axis], std::abs(points[i][axis]));
    }
  }
  const double largest = std::max({ largests[0], largests[1], largests[2] });
  if (largest == 0.0 || (largest > 1e-60 && largest < 1e60))
  {
    return;
  }
  const int exponent = -std::ilogb(largest);
  for (int i = 0; i < 3 * count; ++i)
  {
    points[i / 3][i % 3] = std::scalbn(points[i / 3][i % 3], exponent);
  }
}

double SizeOf(const double (*points)[3], int count)
{
  double squared = 0.0;
  for (int axis = 0; axis < 3 && count > 0; ++axis)
  {
    double low = points[0][axis], high = low;
    for (int i = 1; i < count; ++i)
    {
      low = std::min(low, points[i][axis]);
      high = std::max(high, points[i][axis]);
    }
    squared += (high - low) * (high - low);
  }
  return std::sqrt(squared);
}
}
