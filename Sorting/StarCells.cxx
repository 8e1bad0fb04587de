#include "StarCells.h"

#include "ConvexCellPoints.h"

#include "vtkCellType.h"
#include "vtkIdList.h"

#include <algorithm>

namespace
{
// Decided in coordinates that are safe.
StarCell::Triangles TrianglesOf(
  const TetrahedralSplit::Solid& solid, const vtkIdType* ids, const double (*points)[3])
{
  std::vector<StarCell::Point> scaled(solid.NumberOfVertices);
  std::copy_n(&points[0][0], 3 * scaled.size(), scaled.front().data());
  auto* coordinates = reinterpret_cast<double(*)[3]>(scaled.data());
  TetrahedralSplit::ScaleIfExtreme(coordinates, solid.NumberOfVertices);
  return FaceTriangles(solid, ids, coordinates).Get();
}
}

// By its sign.
bool StarCells::Find(const StarCell::Triangles& triangles, const vtkIdType* ids,
  const double (*points)[3], int count, const ConvexCellPoints& mesh, Star& star)
{
  if (!StarCell::FindKernel(triangles, points, count, star.Sign, star.Kernel))
  {
    return false;
  }
  star.Kernel = mesh.Round(star.Kernel);
  if (!StarCell::SeesAll(triangles, points, count, star.Sign, star.Kernel))
  {
    return false;
  }
  star.Corners.assign(ids, ids + count);
  star.Weights = StarCell::FindWeights(triangles, points, count, star.Kernel);
  return true;
}

void StarCells::Try(vtkIdType cell, const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
  const double (*points)[3], double sign, const ConvexCellPoints& mesh, ConvexCellPlan& plan,
  ConvexCellCursor& cursor)
{
  Star star;
  star.Sign = sign;
  const StarCell::Triangles triangles = TrianglesOf(solid, ids, points);
  if (!Find(triangles, ids, points, solid.NumberOfVertices, mesh, star))
  {
    return;
  }
  plan.Fate = ConvexCellPlan::Tetrahedra;
  plan.Star = true;
  plan.Folded = false;
  plan.ButForFlat = false;
  plan.Dropped = 0;
  StarCell::VisitPieces(triangles, points, sign, star.Kernel,
    [&](int, int, int, bool hasVolume)
    {
      plan.Dropped += !hasVolume;
      cursor.Cell += hasVolume;
      cursor.Id += hasVolume ? 4 : 0;
    });
  const std::lock_guard<std::mutex> lock(this->Mutex);
  Star& kept = this->Stars[cell];
  star.Id = kept.Id;
  kept = star;
}

bool StarCells::Split(vtkIdType cell, const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
  const double (*points)[3], ConvexCellPoints& mesh, std::vector<std::array<vtkIdType, 4>>& pieces)
{
  const StarCell::Triangles triangles = TrianglesOf(solid, ids, points);
  for (const double sign : { 1.0, -1.0 })
  {
    Star star;
    star.Sign = sign;
    if (Find(triangles, ids, points, solid.NumberOfVertices, mesh, star))
    {
      star.Id = mesh.Add(star.Kernel, { cell, star.Kernel });
      StarCell::VisitPieces(triangles, points, sign, star.Kernel,
        [&](int a, int b, int c, bool)
        { pieces.push_back({ star.Id, ids[a], ids[b], ids[c] }); });
      this->Stars[cell] = star;
      return true;
    }
  }
  return false;
}

void StarCells::AddPoints(ConvexCellPoints& mesh)
{
  for (auto& star : this->Stars)
  {
    Star& kept = star.second;
    kept.Id = kept.Id < 0 ? mesh.Add(kept.Kernel, { star.first, kept.Kernel }) : kept.Id;
  }
}

void StarCells::Write(vtkIdType cell, const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
  const double (*points)[3], const vtkIdType* outputIds, const ConvexCellArrays& arrays,
  ConvexCellCursor& cursor) const
{
  const Star& star = this->Stars.at(cell);
  StarCell::VisitPieces(TrianglesOf(solid, ids, points), points, star.Sign, star.Kernel,
    [&](int a, int b, int c, bool hasVolume)
    {
      if (hasVolume)
      {
        BeginConvexCell(VTK_TETRA, cell, arrays, cursor);
        for (const vtkIdType id : { star.Id, ids[a], ids[b], ids[c] })
        {
          arrays.Ids[cursor.Id++] = outputIds[id];
        }
      }
    });
}

bool StarCells::GetWeights(vtkIdType cell, vtkIdList* ids, std::vector<double>& weights) const
{
  const auto found = this->Stars.find(cell);
  if (found == this->Stars.end())
  {
    return false;
  }
  const std::vector<vtkIdType>& corners = found->second.Corners;
  ids->SetNumberOfIds(static_cast<vtkIdType>(corners.size()));
  std::copy(corners.begin(), corners.end(), ids->GetPointer(0));
  weights = found->second.Weights;
  return true;
}
