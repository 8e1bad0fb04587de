#include "PlainHexahedron.h"

#include "TetrahedralSplit.h"

namespace
{
// Of two faces across from each other.
#if defined(__GNUC__)
using Pair = double __attribute__((vector_size(16)));
#else
struct Pair
{
  double Values[2];
  double operator[](int face) const { return this->Values[face]; }
  Pair operator+(Pair b) const { return { (*this)[0] + b[0], (*this)[1] + b[1] }; }
  Pair operator-(Pair b) const { return { (*this)[0] - b[0], (*this)[1] - b[1] }; }
  Pair operator*(Pair b) const { return { (*this)[0] * b[0], (*this)[1] * b[1] }; }
};
#endif

struct Vectors
{
  Pair X, Y, Z;
};

Vectors operator-(const Vectors& u, const Vectors& v)
{
  return { u.X - v.X, u.Y - v.Y, u.Z - v.Z };
}

Pair Dot(const Vectors& u, const Vectors& v)
{
  return u.X * v.X + u.Y * v.Y + u.Z * v.Z;
}

Vectors Cross(const Vectors& u, const Vectors& v)
{
  return { u.Y * v.Z - u.Z * v.Y, u.Z * v.X - u.X * v.Z, u.X * v.Y - u.Y * v.X };
}

Pair Swap(Pair a)
{
  return Pair{ a[1], a[0] };
}

Pair Greater(Pair a, Pair b)
{
  return Pair{ a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1] };
}

// Where one of a quadrilateral's ids is the smallest.
int StartOf(const int* corners, const vtkIdType* ids)
{
  const int first = ids[corners[1]] < ids[corners[0]] ? 1 : 0;
  const int second = ids[corners[3]] < ids[corners[2]] ? 3 : 2;
  return ids[corners[second]] < ids[corners[first]] ? second : first;
}

// Of 1/4: what rounding may take from the square of a cosine.
constexpr double HalfSquared = 0.25 * (1.0 + 1e-12);

// Whether the normals of both triangles are within 60 degrees, and far from the ends of doubles.
bool AreAlike(const Vectors& first, const Vectors& second)
{
  const Pair along = Dot(first, second), square = along * along;
  const Pair squares = Dot(first, first) * Dot(second, second);
  bool alike = true;
  for (int face = 0; face < 2; ++face)
  {
    alike &= (along[face] > 0.0) & (square[face] >= HalfSquared * squares[face]) &
             (squares[face] > 1e-290) & (squares[face] < 1e290);
  }
  return alike;
}

// `corners`: of a face, then of the one across.
bool ArePlain(const int* corners, const vtkIdType* ids, const double (*points)[3], double turn)
{
  const int starts[2] = { StartOf(corners, ids), StartOf(corners + 4, ids) };
  Vectors at[4];
  for (int i = 0; i < 4; ++i)
  {
    const double* a = points[corners[(starts[0] + i) & 3]];
    const double* b = points[corners[4 + ((starts[1] + i) & 3)]];
    at[i] = { Pair{ a[0], b[0] }, Pair{ a[1], b[1] }, Pair{ a[2], b[2] } };
  }
  const Vectors diagonal = at[2] - at[0];
  const Vectors first = Cross(at[1] - at[0], diagonal), second = Cross(diagonal, at[3] - at[0]);
  const Pair turns = { turn, turn };
  Pair highest = { -1.0, -1.0 };
  for (const Vectors& corner : at)
  {
    const Vectors arm = Vectors{ Swap(corner.X), Swap(corner.Y), Swap(corner.Z) } - at[0];
    highest = Greater(highest, Greater(turns * Dot(first, arm), turns * Dot(second, arm)));
  }
  return (highest[0] <= 0.0) & (highest[1] <= 0.0) & AreAlike(first, second);
}
}

bool PlainHexahedron::IsConvex(const vtkIdType ids[8], const double (*points)[3], double sign)
{
  // Faces across from each other come in pairs.
  const int* corners = TetrahedralSplit::SolidOf(TetrahedralSplit::Shape::Hexahedron).FaceVertices;
  const double turn = sign > 0.0 ? 1.0 : -1.0;
  return ArePlain(corners, ids, points, turn) && ArePlain(corners + 8, ids, points, turn) &&
         ArePlain(corners + 16, ids, points, turn);
}
