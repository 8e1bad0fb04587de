#include "ConvexCellPlan.h"

#include "vtkCellType.h"

#include <algorithm>
#include <bitset>
#include <cmath>

namespace
{
using TetrahedralSplit::Pieces;
using TetrahedralSplit::Shape;

bool RepeatsAnId(const vtkIdType* ids, int count)
{
  for (int i = 1; i < count; ++i)
  {
    if (std::find(ids, ids + i, ids[i]) != ids + i)
    {
      return true;
    }
  }
  return false;
}

// A power of two, hence exact: determinants of huge or tiny coordinates neither overflow nor
// vanish.
void ScaleIfExtreme(double (*points)[3], int count)
{
  double largest = 0.0;
  for (int i = 0; i < 3 * count; ++i)
  {
    largest = std::max(largest, std::abs(points[i / 3][i % 3]));
  }
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

// Returns the sum of the pieces' volumes, times six.
double WeighPieces(const Pieces& pieces, const double (*points)[3], ConvexCellPlan& plan)
{
  double sum = 0.0;
  for (int piece = 0; piece < pieces.Count; ++piece)
  {
    const unsigned char* v = pieces.Vertex[piece];
    const double volume =
      TetrahedralSplit::SixVolumes(points[v[0]], points[v[1]], points[v[2]], points[v[3]]);
    plan.Dropped += volume == 0.0;
    plan.Kept |= (volume != 0.0) << piece;
    plan.Turned |= (volume < 0.0) << piece;
    sum += volume;
  }
  return sum;
}

int VTKType(Shape shape)
{
  constexpr int types[] = { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON };
  return types[static_cast<int>(shape)];
}

void BeginCell(
  int type, vtkIdType sourceCell, const ConvexCellArrays& arrays, ConvexCellCursor& cursor)
{
  arrays.Types[cursor.Cell] = static_cast<unsigned char>(type);
  arrays.Offsets[cursor.Cell] = cursor.Id;
  arrays.SourceCells[cursor.Cell] = sourceCell;
  ++cursor.Cell;
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
  Shape shape, const vtkIdType* ids, double (*points)[3], bool tetrahedraOnly)
{
  const int count = TetrahedralSplit::NumberOfVertices(shape);
  ScaleIfExtreme(points, count);
  ConvexCellPlan plan;
  const Pieces pieces = TetrahedralSplit::Split(shape, ids);
  plan.Inverted = WeighPieces(pieces, points, plan) < 0.0;
  plan.Folded = plan.Turned != 0 && plan.Turned != plan.Kept;
  const bool cut = tetrahedraOnly || RepeatsAnId(ids, count);
  plan.Fate = cut ? ConvexCellPlan::Tetrahedra : ConvexCellPlan::Whole;
  if (plan.Kept == 0)
  {
    plan.Fate = ConvexCellPlan::ZeroVolume;
  }
  if (plan.Fate == ConvexCellPlan::Whole)
  {
    plan.Dropped = 0;
  }
  return plan;
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
    const auto count = static_cast<vtkIdType>(std::bitset<8>(plan.Kept).count());
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
    BeginCell(VTKType(shape), sourceCell, arrays, cursor);
    for (int i = 0; i < count; ++i)
    {
      const int vertex = plan.Inverted ? TetrahedralSplit::TurnedVertex(shape, i) : i;
      arrays.Ids[cursor.Id++] = named[vertex];
    }
    return;
  }
  const Pieces pieces = TetrahedralSplit::Split(shape, ids);
  for (int piece = 0; piece < pieces.Count; ++piece)
  {
    if (plan.Kept >> piece & 1)
    {
      BeginCell(VTK_TETRA, sourceCell, arrays, cursor);
      WritePiece(pieces.Vertex[piece], plan.Turned >> piece & 1, named, arrays, cursor);
    }
  }
}
