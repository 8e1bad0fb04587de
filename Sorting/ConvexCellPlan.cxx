#include "ConvexCellPlan.h"

#include "ConvexityTest.h"
#include "FaceTriangles.h"

#include "vtkCellType.h"

#include <algorithm>
#include <bitset>
#include <cmath>

namespace
{
using TetrahedralSplit::Pieces;
using TetrahedralSplit::Shape;

// Of the product of three edges.
constexpr double FlatShare = 1e-9;

bool RepeatsAnId(const vtkIdType* ids, int count)
{
  bool repeats = false;
  for (int i = 1; i < count; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      repeats |= ids[i] == ids[j];
    }
  }
  return repeats;
}

// Six times the volume that the tetrahedron over a flat triangle of a face can have.
double LargestOverFlat(double size)
{
  return 0.25 * FaceTriangles::Straight * size * size * size;
}

// Returns the sum of the pieces' volumes, times six.
double WeighPieces(
  const Pieces& pieces, const vtkIdType* ids, const double (*points)[3], double thin,
  ConvexCellPlan& plan)
{
  double sum = 0.0;
  for (int piece = 0; piece < pieces.Count; ++piece)
  {
    const unsigned char* v = pieces.Vertex[piece];
    const double volume =
      TetrahedralSplit::SixVolumes(points[v[0]], points[v[1]], points[v[2]], points[v[3]]);
    if (std::abs(volume) <= thin)
    {
      const vtkIdType corners[4] = { ids[v[0]], ids[v[1]], ids[v[2]], ids[v[3]] };
      const bool repeats = RepeatsAnId(corners, 4);
      plan.Thin = plan.Thin || !repeats;
      plan.Uneven = plan.Uneven || (volume == 0.0 && !repeats);
    }
    plan.Dropped += volume == 0.0;
    plan.Kept |= static_cast<std::uint32_t>(volume != 0.0) << piece;
    plan.Turned |= static_cast<std::uint32_t>(volume < 0.0) << piece;
    sum += volume;
  }
  return sum;
}

// Looks for a corner from which all pieces have one sign; those of the other are flat.
void Unfold(Shape shape, const vtkIdType* ids, const double (*points)[3], ConvexCellPlan& plan)
{
  const auto& solid = TetrahedralSplit::SolidOf(shape);
  const int apex = TetrahedralSplit::FindApex(solid, ids, points, plan.Inverted ? -1.0 : 1.0);
  if (apex < 0)
  {
    return;
  }
  ConvexCellPlan other;
  const Pieces pieces = TetrahedralSplit::Split(shape, ids, apex);
  WeighPieces(pieces, ids, points, -1.0, other);
  plan.Apex = apex;
  plan.Kept = plan.Inverted ? other.Turned : other.Kept & ~other.Turned;
  plan.ButForFlat = plan.Kept != other.Kept;
  plan.Turned = plan.Inverted ? other.Turned : 0;
  plan.Dropped = pieces.Count - static_cast<int>(std::bitset<32>(plan.Kept).count());
  plan.Folded = false;
}

// Whether six times a tetrahedron's volume is too little of what its edges span to tell which way
// the faces of a cell are wound.
bool IsFlat(
  double volume, const double a[3], const double b[3], const double c[3], const double d[3])
{
  double squared = FlatShare * FlatShare;
  for (const double* end : { b, c, d })
  {
    const double x = end[0] - a[0], y = end[1] - a[1], z = end[2] - a[2];
    squared *= x * x + y * y + z * z;
  }
  return volume * volume <= squared;
}

// Most cells are convex, and then one tetrahedron tells which way their faces are wound.
bool TakeWhole(const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
  const double (*points)[3], ConvexCellPlan& plan)
{
  const int* face = solid.Begin(0);
  int off = 0;
  while (solid.Touches(0, off))
  {
    ++off;
  }
  const double volume =
    TetrahedralSplit::SixVolumes(points[off], points[face[0]], points[face[1]], points[face[2]]);
  if (IsFlat(volume, points[off], points[face[0]], points[face[1]], points[face[2]]) ||
    !ConvexityTest::IsConvex(solid, ids, points, volume))
  {
    return false;
  }
  plan.Fate = ConvexCellPlan::Whole;
  plan.Inverted = volume < 0.0;
  return true;
}

int VTKType(Shape shape)
{
  constexpr int types[] = { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON, VTK_PENTAGONAL_PRISM,
    VTK_HEXAGONAL_PRISM };
  return types[static_cast<int>(shape)];
}

void WritePiece(const unsigned char* vertex, bool turned, const vtkIdType* ids,
  const ConvexCellArrays& arrays, ConvexCellCursor& cursor)
{
  arrays.Ids[cursor.Id++] = ids[vertex[0]];
  arrays.Ids[cursor.Id++] = ids[vertex[1]];
  arrays.Ids[cursor.Id++] = ids[vertex[turned ? 3 : 2]];
  arrays.Ids[cursor.Id++] = ids[vertex[turned ? 2 : 3]];
}
}

ConvexCellPlan PlanConvexCell(
  Shape shape, const vtkIdType* ids, double (*points)[3], ConvexCellCut cut)
{
  const auto& solid = TetrahedralSplit::SolidOf(shape);
  TetrahedralSplit::ScaleIfExtreme(points, solid.NumberOfVertices);
  const bool repeats = RepeatsAnId(ids, solid.NumberOfVertices);
  ConvexCellPlan plan;
  if (cut == ConvexCellCut::NonConvex && !repeats && TakeWhole(solid, ids, points, plan))
  {
    return plan;
  }
  const double thin =
    LargestOverFlat(TetrahedralSplit::SizeOf(points, solid.NumberOfVertices));
  const double sum =
    WeighPieces(TetrahedralSplit::Split(shape, ids), ids, points, thin, plan);
  plan.Inverted = sum < 0.0;
  plan.Fate = plan.Kept == 0 ? ConvexCellPlan::ZeroVolume : ConvexCellPlan::Tetrahedra;
  if (plan.Kept != 0 && !repeats && cut != ConvexCellCut::All)
  {
    const bool whole = cut == ConvexCellCut::None ||
                       ConvexityTest::IsConvex(solid, ids, points, plan.Inverted ? -1.0 : 1.0);
    plan.NonConvex = !whole;
    plan.Fate = whole ? ConvexCellPlan::Whole : ConvexCellPlan::Tetrahedra;
    plan.Dropped = whole ? 0 : plan.Dropped;
  }
  plan.Folded =
    plan.Fate == ConvexCellPlan::Tetrahedra && plan.Turned != 0 && plan.Turned != plan.Kept;
  plan.Uneven = plan.Uneven || plan.Folded;
  if (plan.Folded)
  {
    Unfold(shape, ids, points, plan);
  }
  return plan;
}

void BeginConvexCell(
  int type, vtkIdType sourceCell, const ConvexCellArrays& arrays, ConvexCellCursor& cursor)
{
  arrays.Types[cursor.Cell] = static_cast<unsigned char>(type);
  arrays.Offsets[cursor.Cell] = cursor.Id;
  arrays.SourceCells[cursor.Cell] = sourceCell;
  ++cursor.Cell;
}

void SkipConvexCell(const ConvexCellPlan& plan, Shape shape, ConvexCellCursor& cursor)
{
  if (plan.Fate == ConvexCellPlan::Whole)
  {
    cursor.Cell += 1;
    cursor.Id += TetrahedralSplit::NumberOfVertices(shape);
  }
  else if (plan.Fate == ConvexCellPlan::Tetrahedra)
  {
    const auto count = static_cast<vtkIdType>(std::bitset<32>(plan.Kept).count());
    cursor.Cell += count;
    cursor.Id += 4 * count;
  }
}

void WriteConvexCell(const ConvexCellPlan& plan, Shape shape, const vtkIdType* ids,
  const vtkIdType* outputIds, vtkIdType sourceCell, const ConvexCellArrays& arrays,
  ConvexCellCursor& cursor)
{
  const int count = TetrahedralSplit::NumberOfVertices(shape);
  vtkIdType named[TetrahedralSplit::MaximumVertices];
  for (int i = 0; i < count; ++i)
  {
    named[i] = outputIds ? outputIds[ids[i]] : ids[i];
  }
  if (plan.Fate == ConvexCellPlan::Whole)
  {
    BeginConvexCell(VTKType(shape), sourceCell, arrays, cursor);
    for (int i = 0; i < count; ++i)
    {
      const int vertex = plan.Inverted ? TetrahedralSplit::TurnedVertex(shape, i) : i;
      arrays.Ids[cursor.Id++] = named[vertex];
    }
    return;
  }
  const Pieces pieces = TetrahedralSplit::Split(shape, ids, plan.Apex);
  for (int piece = 0; piece < pieces.Count; ++piece)
  {
    if (plan.Kept >> piece & 1)
    {
      BeginConvexCell(VTK_TETRA, sourceCell, arrays, cursor);
      WritePiece(pieces.Vertex[piece], plan.Turned >> piece & 1, named, arrays, cursor);
    }
  }
}
