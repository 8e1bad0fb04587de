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

void StarCells::Try(vtkIdType cell, const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
  const double (*points)[3], double sign, const ConvexCellPoints& mesh, ConvexCellPlan& plan,
  ConvexCellCursor& cursor)
{
  Star star;
  star.Sign = sign;
  const int count = solid.NumberOfVertices;
  const StarCell::Triangles triangles = TrianglesOf(solid, ids, points);
  if (!StarCell::FindKernel(triangles, points, count, sign, star.Kernel))
  {
    return;
  }
  star.Kernel = mesh.Round(star.Kernel);
  if (!StarCell::SeesAll(triangles, points, count, sign, star.Kernel))
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
  star.Corners.assign(ids, ids + count);
  star.Weights = StarCell::FindWeights(triangles, points, count, star.Kernel);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Stars[cell] = star;
}

void StarCells::AddPoints(ConvexCellPoints& mesh)
{
  for (auto& star : this->Stars)
  {
    star.second.Id = mesh.Add(star.second.Kernel, { star.first, star.second.Kernel });
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
