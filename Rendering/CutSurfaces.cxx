#include "CutSurfaces.h"

#include "FacePieces.h"
#include "PreparedVolume.h"

#include <glm/gtc/type_ptr.hpp>

namespace
{
NearPlaneCut::Triangle CornersOf(
  const PassTriangles::Triangle& triangle, const FacePieces& pieces, const PreparedVolume& prepared)
{
  NearPlaneCut::Triangle corners;
  for (int i = 0; i < 3; ++i)
  {
    const auto id =
      static_cast<size_t>(pieces.Corners[triangle[0]][PassTriangles::CornerOfPiece(triangle, i)]);
    const float scalar = prepared.Scalars.OnePerCell ? 0.0f : prepared.Scalars.Values[id];
    corners[i] = glm::vec4(glm::make_vec3(&prepared.Coordinates.Points[4 * id]), scalar);
  }
  return corners;
}
}

//------------------------------------------------------------------------------
void CutSurfaces::Build(const std::vector<unsigned int>& cut, const glm::vec4& nearPlane,
  const PassTriangles& whole, const FacePieces& pieces, const PreparedVolume& prepared)
{
  *this = CutSurfaces();
  NearPlaneCut surface(nearPlane);
  for (const unsigned int cell : cut)
  {
    const int at = whole.Find(static_cast<int>(cell));
    if (at < 0)
    {
      continue;
    }
    // The first of three passes has them all.
    const int first = whole.Offsets[at];
    const int count = (whole.Offsets[at + 1] - first) / 3;
    for (int i = first; i < first + count; ++i)
    {
      surface.AddTriangle(CornersOf(whole.Triangles[i], pieces, prepared));
    }
    const std::vector<NearPlaneCut::Triangle> part = surface.Finish();
    this->Passes.AppendExplicit(static_cast<int>(cell), static_cast<int>(part.size()));
    this->Vertices.insert(this->Vertices.end(), part.begin(), part.end());
  }
}
