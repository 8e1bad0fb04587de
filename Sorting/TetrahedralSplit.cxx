#include "TetrahedralSplit.h"

#include <cmath>

namespace
{
using TetrahedralSplit::Pieces;
using TetrahedralSplit::Shape;

struct Face
{
  int Size;
  unsigned char Vertex[4];
};

struct Solid
{
  int NumberOfVertices;
  int NumberOfFaces;
  Face Faces[6];                // counter-clockwise from outside, as VTK's GetFace
  unsigned char TurnedOrder[8]; // the mirror image's numbering
};

// By Shape. VTK's wedge has its first triangle facing outward, unlike its tetrahedron.
constexpr Solid Solids[] = {
  { 4, 4, { { 3, { 0, 1, 3 } }, { 3, { 1, 2, 3 } }, { 3, { 2, 0, 3 } }, { 3, { 0, 2, 1 } } },
    { 0, 1, 3, 2 } },
  { 5, 5,
    { { 4, { 0, 3, 2, 1 } }, { 3, { 0, 1, 4 } }, { 3, { 1, 2, 4 } }, { 3, { 2, 3, 4 } },
      { 3, { 3, 0, 4 } } },
    { 0, 3, 2, 1, 4 } },
  { 6, 5,
    { { 3, { 0, 1, 2 } }, { 3, { 3, 5, 4 } }, { 4, { 0, 3, 4, 1 } }, { 4, { 1, 4, 5, 2 } },
      { 4, { 2, 5, 3, 0 } } },
    { 3, 4, 5, 0, 1, 2 } },
  { 8, 6,
    { { 4, { 0, 4, 7, 3 } }, { 4, { 1, 2, 6, 5 } }, { 4, { 0, 1, 5, 4 } }, { 4, { 3, 7, 6, 2 } },
      { 4, { 0, 3, 2, 1 } }, { 4, { 4, 5, 6, 7 } } },
    { 4, 5, 6, 7, 0, 1, 2, 3 } },
};

// Of a hexahedron's vertex: the one across the cell, and the three next to it, such that vertex and
// neighbours make a positive tetrahedron.
constexpr unsigned char Antipode[8] = { 6, 7, 4, 5, 2, 3, 0, 1 };
constexpr unsigned char Neighbours[8][3] = { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 },
  { 7, 5, 0 }, { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } };

const Solid& SolidOf(Shape shape)
{
  return Solids[static_cast<int>(shape)];
}

bool Touches(const Face& face, int vertex)
{
  return face.Vertex[0] == vertex || face.Vertex[1] == vertex || face.Vertex[2] == vertex ||
         (face.Size == 4 && face.Vertex[3] == vertex);
}

int SmallestVertex(const Solid& solid, const vtkIdType* ids)
{
  int smallest = 0;
  for (int vertex = 1; vertex < solid.NumberOfVertices; ++vertex)
  {
    smallest = ids[vertex] < ids[smallest] ? vertex : smallest;
  }
  return smallest;
}

// Where in the face's list its diagonal starts; it ends two further on.
int DiagonalStart(const Face& face, const vtkIdType* ids)
{
  int start = 0;
  for (int position = 1; position < face.Size; ++position)
  {
    start = ids[face.Vertex[position]] < ids[face.Vertex[start]] ? position : start;
  }
  return start;
}

// Positive where abc, seen from a, b, c's far side, turns counter-clockwise.
void AddTetrahedron(Pieces& pieces, int apex, int a, int b, int c)
{
  unsigned char* vertex = pieces.Vertex[pieces.Count++];
  vertex[0] = static_cast<unsigned char>(apex);
  vertex[1] = static_cast<unsigned char>(a);
  vertex[2] = static_cast<unsigned char>(b);
  vertex[3] = static_cast<unsigned char>(c);
}

// Joins the apex to the triangles of a face; those that touch `skipped` are left out.
void AddFace(Pieces& pieces, int apex, const Face& face, const vtkIdType* ids, int skipped)
{
  const int start = face.Size == 4 ? DiagonalStart(face, ids) : 0;
  for (int step = 1; step + 1 < face.Size; ++step)
  {
    const int a = face.Vertex[start];
    const int b = face.Vertex[(start + step) % face.Size];
    const int c = face.Vertex[(start + step + 1) % face.Size];
    if (a != skipped && b != skipped && c != skipped)
    {
      AddTetrahedron(pieces, apex, a, b, c);
    }
  }
}

bool DiagonalEndsIn(int vertex, const vtkIdType* ids)
{
  for (const Face& face : SolidOf(Shape::Hexahedron).Faces)
  {
    const int start = DiagonalStart(face, ids);
    if (face.Vertex[start] == vertex || face.Vertex[(start + 2) % 4] == vertex)
    {
      return true;
    }
  }
  return false;
}
}

namespace TetrahedralSplit
{
int NumberOfVertices(Shape shape)
{
  return SolidOf(shape).NumberOfVertices;
}

Pieces Split(Shape shape, const vtkIdType* ids)
{
  Pieces pieces;
  if (shape == Shape::Tetrahedron)
  {
    AddTetrahedron(pieces, 0, 1, 2, 3);
    return pieces;
  }
  const Solid& solid = SolidOf(shape);
  const int apex = SmallestVertex(solid, ids);
  int corner = -1;
  if (shape == Shape::Hexahedron && !DiagonalEndsIn(Antipode[apex], ids))
  {
    corner = Antipode[apex];
    const unsigned char* next = Neighbours[corner];
    AddTetrahedron(pieces, corner, next[0], next[1], next[2]);
    AddTetrahedron(pieces, apex, next[0], next[2], next[1]);
  }
  for (int index = 0; index < solid.NumberOfFaces; ++index)
  {
    if (!Touches(solid.Faces[index], apex))
    {
      AddFace(pieces, apex, solid.Faces[index], ids, corner);
    }
  }
  return pieces;
}

int TurnedVertex(Shape shape, int position)
{
  return SolidOf(shape).TurnedOrder[position];
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
}
