/**
 * The faces of one convex cell on the screen in double, for those too steep or too slender for floats.
 */
#if defined(ConvexTileScreenFaces_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef ConvexTileScreenFaces_inl_h
#undef ConvexTileScreenFaces_inl_h
#else
#define ConvexTileScreenFaces_inl_h
#endif

#include "ConvexTileEnds-inl.h"
#include "ConvexTileFaceLanes-inl.h"
#include "ConvexTileFaces.h"
#include "ConvexTileMesh.h"
#include "ConvexTileTask.h"
#include "TileView.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

class ScreenFaces
{
public:
  using Face = ConvexTileFaceOf<double>;

  /// Of a cell whose corners all lie between the near and the far plane; false where one of its faces is
  /// seen edge-on even so, or has more than two triangles, and where there are too many.
  bool SetUp(const ConvexTileTask& task, int cell)
  {
    const ConvexCellFaces::Rows& rows = task.Mesh->Faces;
    const FaceLimits<double> limits(*task.Common.View, task.Bounds);
    const int count = rows.GetSize(cell), lanes = static_cast<int>(hn::Lanes(LaneDouble()));
    if (count > ConvexTileMesh::MostFaces)
    {
      return false;
    }
    for (int first = 0; first < count; first += lanes)
    {
      if (!this->Gather(*task.Mesh, rows.GetRow(cell) + first, count - first))
      {
        return false;
      }
      this->Project(*task.Common.View, limits, first);
    }
    return std::none_of(
      this->Faces, this->Faces + count, [](const Face& face) { return face.Side == 0.0; });
  }

  const Face& operator[](int i) const { return this->Faces[i]; }

private:
  static constexpr int Lanes = hn::MaxLanes(LaneDouble());

  /// The corners of a vector of faces; the last one is repeated.
  bool Gather(const ConvexTileMesh& mesh, const int* faces, int count)
  {
    const FacePieces& pieces = *mesh.Pieces;
    for (int k = 0; k < Lanes; ++k)
    {
      const int face = faces[std::min(k, count - 1)], kind = mesh.FaceKinds[face];
      if ((kind & ConvexTileMesh::MoreTriangles) != 0)
      {
        return false;
      }
      const std::array<int, 4>& ids = pieces.Corners[pieces.Offsets[face]];
      for (int i = 0; i < 4; ++i)
      {
        const float* const point = &mesh.Points[4 * static_cast<std::size_t>(ids[i])];
        for (int part = 0; part < 4; ++part)
        {
          this->Corners[i][part][k] = point[part];
        }
      }
      this->Kinds[0][k] = kind & ConvexTileMesh::TwoTriangles;
      this->Kinds[1][k] = kind & ConvexTileMesh::Warped;
      this->Kinds[2][k] = kind & ConvexTileMesh::Step;
    }
    return true;
  }

  void Project(const TileView& view, const FaceLimits<double>& limits, int first)
  {
    const LaneDouble d;
    const auto corners = [&](int i, LaneVector (&to)[4]) { this->ToScreen(view, i, to); };
    const auto flag = [&](int kind) { return hn::Gt(hn::Load(d, this->Kinds[kind]), hn::Zero(d)); };
    double* const out[4] = { this->Out[0][0], this->Out[1][0], this->Out[2][0], this->Out[3][0] };
    ProjectFaceLanes(
      d, corners, FaceKinds<LaneDouble>{ flag(0), flag(1), flag(2) }, limits, out);
    for (int k = 0; k < Lanes; ++k)
    {
      CopyFace(this->Out, k, this->Faces[first + k]);
    }
  }

  /// x, y, u and the scalar of a corner.
  HWY_INLINE void ToScreen(const TileView& view, int corner, LaneVector (&to)[4]) const
  {
    const LaneDouble d;
    const auto& c = this->Corners[corner];
    const auto x = hn::Load(d, c[0]), y = hn::Load(d, c[1]), z = hn::Load(d, c[2]);
    const glm::dmat4& m = view.MeshToScreen;
    const auto row = [&](int i)
    {
      return hn::MulAdd(hn::Set(d, m[0][i]), x,
        hn::MulAdd(hn::Set(d, m[1][i]), y,
          hn::MulAdd(hn::Set(d, m[2][i]), z, hn::Set(d, m[3][i]))));
    };
    const auto inverse = hn::Div(hn::Set(d, 1.0), row(3));
    for (int i = 0; i < 3; ++i)
    {
      to[i] = hn::Mul(row(i), inverse);
    }
    to[3] = hn::Load(d, c[3]);
  }

  HWY_ALIGN double Corners[4][4][Lanes];
  HWY_ALIGN double Kinds[3][Lanes];
  HWY_ALIGN double Out[4][Lanes][4];
  Face Faces[ConvexTileMesh::MostFaces + Lanes];
};
}
}
HWY_AFTER_NAMESPACE();

#endif
