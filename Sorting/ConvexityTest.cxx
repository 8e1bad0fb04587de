#include "ConvexityTest.h"

#include "PlainHexahedron.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace
{
using TetrahedralSplit::Solid;

struct Vector
{
  double X, Y, Z;
};

Vector Difference(const double a[3], const double b[3])
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const Vector& u, const Vector& v)
{
  return u.X * v.X + u.Y * v.Y + u.Z * v.Z;
}

Vector Cross(const Vector& u, const Vector& v)
{
  return { u.Y * v.Z - u.Z * v.Y, u.Z * v.X - u.X * v.Z, u.X * v.Y - u.Y * v.X };
}

/** The faces of one cell. */
class Cell
{
public:
  Cell(const Solid& solid, const vtkIdType* ids, const double (*points)[3], double sign)
    : Surface(solid)
    , Ids(ids)
    , Points(points)
    , Sign(sign)
    , Size(TetrahedralSplit::SizeOf(points, solid.NumberOfVertices))
  {
    if (solid.NumberOfVertices > Few)
    {
      this->ManyOffFace.resize(solid.NumberOfVertices);
      this->OffFace = this->ManyOffFace.data();
    }
  }
  Cell(const Cell&) = delete;

  bool IsConvexAt(int face);

private:
  bool IsPlanar(int face) const;
  void FindOffFace(int face);
  bool AllInside(int onPlane, const Vector& normal, double length) const;

  static constexpr int Few = 32;

  const Solid& Surface;
  const vtkIdType* Ids;
  const double (*Points)[3];
  const double Sign;
  const double Size;
  Vector FewOffFace[Few];
  std::vector<Vector> ManyOffFace;
  Vector* OffFace = FewOffFace; // the vertices that are not on the face at hand
  Vector* OffFaceEnd = OffFace;
};

void Cell::FindOffFace(int face)
{
  const bool fits = this->Surface.NumberOfVertices <= 64;
  std::uint64_t on = 0;
  for (const int* at = this->Surface.Begin(face); fits && at < this->Surface.End(face); ++at)
  {
    on |= std::uint64_t{ 1 } << *at;
  }
  int count = 0;
  for (int vertex = 0; vertex < this->Surface.NumberOfVertices; ++vertex)
  {
    const double* x = this->Points[vertex];
    this->OffFace[count] = { x[0], x[1], x[2] };
    count += !(fits ? on >> vertex & 1 : this->Surface.Touches(face, vertex));
  }
  this->OffFaceEnd = this->OffFace + count;
}

bool Cell::AllInside(int onPlane, const Vector& normal, double length) const
{
  const double bound = ConvexityTest::InsideTolerance * this->Size * length;
  const double* origin = this->Points[onPlane];
  double highest = 0.0;
  for (const Vector* x = this->OffFace; x < this->OffFaceEnd; ++x)
  {
    const Vector arm = { x->X - origin[0], x->Y - origin[1], x->Z - origin[2] };
    highest = std::max(highest, Dot(normal, arm));
  }
  return highest <= bound;
}

bool Cell::IsPlanar(int face) const
{
  const int* begin = this->Surface.Begin(face);
  const int* end = this->Surface.End(face);
  Vector normal = { 0, 0, 0 };
  double reach = 0.0;
  for (const int* at = begin + 1; at + 1 < end; ++at)
  {
    const Vector u = Difference(this->Points[at[0]], this->Points[*begin]);
    const Vector v = Difference(this->Points[at[1]], this->Points[*begin]);
    const Vector area = Cross(u, v);
    normal = { normal.X + area.X, normal.Y + area.Y, normal.Z + area.Z };
    reach = std::max({ reach, Dot(u, u), Dot(v, v) });
  }
  const double bound =
    ConvexityTest::PlanarTolerance * std::sqrt(reach) * std::sqrt(Dot(normal, normal));
  return std::all_of(begin, end,
    [&](int vertex)
    {
      const Vector arm = Difference(this->Points[vertex], this->Points[*begin]);
      return std::abs(Dot(normal, arm)) <= bound;
    });
}

bool Cell::IsConvexAt(int face)
{
  if (this->Surface.End(face) - this->Surface.Begin(face) > 4 && !this->IsPlanar(face))
  {
    return false;
  }
  this->FindOffFace(face);
  // Of a planar face the first triangle speaks for all.
  Vector first = { 0, 0, 0 };
  double firstLength = 0.0;
  bool convex = true;
  TetrahedralSplit::VisitTriangles(this->Surface, face, this->Ids,
    [&](int a, int b, int c)
    {
      const double* origin = this->Points[a];
      const Vector u = Difference(this->Points[b], origin);
      const Vector v = Difference(this->Points[c], origin);
      const Vector normal = this->Sign > 0.0 ? Cross(u, v) : Cross(v, u);
      const double length = std::sqrt(Dot(normal, normal));
      if (convex && length > 1e-12 * this->Size * this->Size)
      {
        first = firstLength > 0.0 ? first : normal;
        firstLength = firstLength > 0.0 ? firstLength : length;
        convex =
          Dot(first, normal) >= 0.5 * firstLength * length && this->AllInside(a, normal, length);
      }
    });
  return convex;
}
}

namespace ConvexityTest
{
bool IsConvex(const Solid& solid, const vtkIdType* ids, const double (*points)[3], double sign)
{
  if (&solid == &TetrahedralSplit::SolidOf(TetrahedralSplit::Shape::Hexahedron) &&
    PlainHexahedron::IsConvex(ids, points, sign))
  {
    return true;
  }
  Cell cell(solid, ids, points, sign);
  for (int face = 0; face < solid.NumberOfFaces; ++face)
  {
    if (!cell.IsConvexAt(face))
    {
      return false;
    }
  }
  return true;
}

bool IsBox(const double (*points)[3])
{
  constexpr int high[3][4] = { { 1, 2, 5, 6 }, { 2, 3, 6, 7 }, { 4, 5, 6, 7 } };
  constexpr int low[3][4] = { { 0, 3, 4, 7 }, { 0, 1, 4, 5 }, { 0, 1, 2, 3 } };
  bool isBox = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 1; i < 4; ++i)
    {
      isBox = isBox && points[high[axis][i]][axis] == points[high[axis][0]][axis] &&
              points[low[axis][i]][axis] == points[low[axis][0]][axis];
    }
  }
  return isBox;
}
}
