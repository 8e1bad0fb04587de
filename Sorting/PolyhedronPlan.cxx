#include "PolyhedronPlan.h"

#include "ConePlan.h"
#include "ConvexityTest.h"
#include "FaceTriangles.h"

#include "vtkCellType.h"
#include "vtkMath.h"

#include <algorithm>
#include <array>

namespace
{
using TetrahedralSplit::Solid;

ConvexCellPlan::FateType FateOf(PolyhedronSurface::Defect defect)
{
  switch (defect)
  {
    case PolyhedronSurface::Defect::WrongList:
      return ConvexCellPlan::WrongList;
    case PolyhedronSurface::Defect::Open:
      return ConvexCellPlan::Open;
    case PolyhedronSurface::Defect::SeveralPieces:
      return ConvexCellPlan::SeveralPieces;
    default:
      return ConvexCellPlan::Whole;
  }
}

// Six times; positive where the faces are wound outward.
double SumVolumes(const PolyhedronSurface& surface, const double (*points)[3])
{
  double sum = 0.0;
  TetrahedralSplit::VisitCone(surface.GetSolid(), surface.GetIds().data(), 0,
    [&](int, int a, int b, int c)
    { sum += TetrahedralSplit::SixVolumes(points[0], points[a], points[b], points[c]); });
  return sum;
}

// Of length 1, as wound; 0 where the face has no area.
void NormalOf(const Solid& solid, int face, const double (*points)[3], double normal[3])
{
  std::fill_n(normal, 3, 0.0);
  const int* begin = solid.Begin(face);
  for (const int* at = begin + 2; at < solid.End(face); ++at)
  {
    double u[3], v[3], cross[3];
    vtkMath::Subtract(points[at[-1]], points[*begin], u);
    vtkMath::Subtract(points[*at], points[*begin], v);
    vtkMath::Cross(u, v, cross);
    vtkMath::Add(normal, cross, normal);
  }
  vtkMath::Normalize(normal);
}

// Whether two of a convex cell's faces lie in one plane, as beside a refined cell of an octree: where
// a ray enters, their planes do not tell which one holds the scalar.
bool HasDividedSide(const Solid& solid, const double (*points)[3])
{
  constexpr double Together = 1.0 - 0.5 * FaceTriangles::Straight * FaceTriangles::Straight;
  std::vector<std::array<double, 3>> normals(solid.NumberOfFaces);
  for (int face = 0; face < solid.NumberOfFaces; ++face)
  {
    NormalOf(solid, face, points, normals[face].data());
    const auto isSame = [&](const std::array<double, 3>& other)
    { return vtkMath::Dot(other.data(), normals[face].data()) >= Together; };
    if (std::any_of(normals.begin(), normals.begin() + face, isSame))
    {
      return true;
    }
  }
  return false;
}

void WriteWhole(const Solid& solid, const vtkIdType* named, const ConvexCellArrays& arrays,
  ConvexCellCursor& cursor)
{
  arrays.Ids[cursor.Id++] = solid.NumberOfFaces;
  for (int face = 0; face < solid.NumberOfFaces; ++face)
  {
    arrays.Ids[cursor.Id++] = solid.End(face) - solid.Begin(face);
    for (const int* at = solid.Begin(face); at < solid.End(face); ++at)
    {
      arrays.Ids[cursor.Id++] = named[*at];
    }
  }
}
}

ConvexCellPlan::FateType TurnOutward(PolyhedronSurface& surface, double (*points)[3])
{
  const ConvexCellPlan::FateType fate = FateOf(surface.Orient());
  if (fate != ConvexCellPlan::Whole)
  {
    return fate;
  }
  TetrahedralSplit::ScaleIfExtreme(points, surface.GetSolid().NumberOfVertices);
  const double volume = SumVolumes(surface, points);
  if (volume < 0.0)
  {
    surface.Turn();
  }
  return volume == 0.0 ? ConvexCellPlan::ZeroVolume : ConvexCellPlan::Whole;
}

ConvexCellPlan PlanPolyhedron(
  PolyhedronSurface& surface, double (*points)[3], ConvexCellCut cut, ConvexCellCursor& cursor)
{
  ConvexCellPlan plan;
  plan.Fate = TurnOutward(surface, points);
  if (plan.Fate != ConvexCellPlan::Whole)
  {
    return plan;
  }
  plan.Inverted = surface.GetNumberOfTurnedFaces() > 0;
  const Solid solid = surface.GetSolid();
  plan.NonConvex = cut == ConvexCellCut::NonConvex &&
                   (!ConvexityTest::IsConvex(solid, surface.GetIds().data(), points, 1.0) ||
                     HasDividedSide(solid, points));
  if (cut == ConvexCellCut::All || plan.NonConvex)
  {
    const FaceTriangles triangles(solid, surface.GetIds().data(), points);
    if (!ConePlan::Make(triangles, points, 1.0, plan, cursor))
    {
      plan.Fate = ConvexCellPlan::Concave;
    }
    return plan;
  }
  cursor.Cell += 1;
  cursor.Id += 1 + solid.NumberOfFaces + solid.FaceOffsets[solid.NumberOfFaces];
  return plan;
}

void PlanButForFlat(const PolyhedronSurface& surface, const double (*points)[3],
  ConvexCellPlan& plan, ConvexCellCursor& cursor)
{
  const FaceTriangles triangles(surface.GetSolid(), surface.GetIds().data(), points);
  ConePlan::Make(triangles, points, 1.0, plan, cursor, TetrahedralSplit::FlatnessTolerance);
}

void WritePolyhedron(const ConvexCellPlan& plan, PolyhedronSurface& surface, double (*points)[3],
  const vtkIdType* outputIds, vtkIdType sourceCell, const ConvexCellArrays& arrays,
  ConvexCellCursor& cursor)
{
  TurnOutward(surface, points);
  std::vector<vtkIdType> named = surface.GetIds();
  for (vtkIdType& id : named)
  {
    id = outputIds ? outputIds[id] : id;
  }
  if (plan.Fate == ConvexCellPlan::Whole)
  {
    BeginConvexCell(VTK_POLYHEDRON, sourceCell, arrays, cursor);
    WriteWhole(surface.GetSolid(), named.data(), arrays, cursor);
    return;
  }
  const FaceTriangles triangles(surface.GetSolid(), surface.GetIds().data(), points);
  ConePlan::Write(plan, triangles, points, 1.0, named.data(), sourceCell, arrays, cursor);
}
