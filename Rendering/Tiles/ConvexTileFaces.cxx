// Compiled once for each instruction set that the machine may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ConvexTileFaces.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "ConvexTileFaces.h"
#include "ConvexTileMesh.h"
#include "TileClusterBlocks.h"
#include "TileRecords-inl.h"
#include "TileVertices.h"
#include "vtkSMPTools.h"

#include "ConvexTileFaceLanes-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using FaceFloat = hn::CappedTag<float, TileRecords::Count>;

/// Faces side by side: what is read of their kinds, and what comes out.
struct FaceGroup
{
  HWY_ALIGN float Out[4][TileRecords::Count][4];
  HWY_ALIGN int Kinds[TileRecords::Count];
  int Pieces[TileRecords::Count];
  TileRecords Corners;

  void Gather(const ConvexTileMesh& mesh, const TileVertices& vertices, int first, int count)
  {
    for (int k = 0; k < TileRecords::Count; ++k)
    {
      const int face = first + std::min(k, count - 1);
      this->Pieces[k] = mesh.Pieces->Offsets[face];
      this->Kinds[k] = mesh.FaceKinds[face];
    }
    this->Corners.Gather(mesh.Pieces->Corners[0].data(), vertices.Values.data(), this->Pieces);
  }

  void Project(int lane, const FaceLimits<float>& limits)
  {
    const FaceFloat d;
    const hn::RebindToSigned<FaceFloat> di;
    const auto kinds = hn::Load(di, this->Kinds + lane);
    const auto is = [&](int kind)
    { return hn::RebindMask(d, hn::TestBit(kinds, hn::Set(di, kind))); };
    const FaceKinds<FaceFloat> all = { is(ConvexTileMesh::TwoTriangles), is(ConvexTileMesh::Warped),
      is(ConvexTileMesh::Step) };
    const auto corners = [&](int i, hn::Vec<FaceFloat>(&to)[4]) { this->Corners.Load(d, i, lane, to); };
    float* const out[4] = { this->Out[0][lane], this->Out[1][lane], this->Out[2][lane],
      this->Out[3][lane] };
    ProjectFaceLanes(d, corners, all, limits, out);
  }

  void CopyTo(int k, ConvexTileFace& face) const
  {
    CopyFace(this->Out, k, face);
    // Faces of more than two triangles are left to class ConvexTileExactCell.
    face.Side = (this->Kinds[k] & ConvexTileMesh::MoreTriangles) != 0 ? 0.0f : face.Side;
  }
};

// NOLINTNEXTLINE: Highway's dispatch table names it.
void ProjectFaces(const ConvexTileMesh& mesh, const TileView& view, const TileVertices& vertices,
  const ConvexTileFaces::Bounds& bounds, int begin, int end, ConvexTileFaces& faces)
{
  const FaceLimits<float> limits(view, bounds);
  FaceGroup group;
  for (int first = begin; first < end; first += TileRecords::Count)
  {
    const int count = std::min(end - first, TileRecords::Count);
    group.Gather(mesh, vertices, first, count);
    for (int lane = 0; lane < TileRecords::Count; lane += static_cast<int>(hn::Lanes(FaceFloat())))
    {
      group.Project(lane, limits);
    }
    for (int k = 0; k < count; ++k)
    {
      ConvexTileFace& face = faces.Values[first + k];
      group.CopyTo(k, face);
      faces.InDoubt[first + k] = face.Side == 0.0f ? 1 : 0;
    }
  }
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace CellProjectionTiles
{
HWY_EXPORT(ProjectFaces);
}

//------------------------------------------------------------------------------
void ConvexTileFaces::Project(const ConvexTileMesh& mesh, const TileView& view,
  const TileVertices& vertices, const TileClusterBlocks& blocks, const Bounds& bounds)
{
  const int faces = mesh.GetNumberOfFaces();
  this->Values.resize(static_cast<std::size_t>(faces));
  this->InDoubt.resize(static_cast<std::size_t>(faces));
  constexpr int Size = TileClusterBlocks::Size;
  vtkSMPTools::For(0, (faces + Size - 1) / Size, 128,
    [&](vtkIdType begin, vtkIdType end)
    {
      const auto isSeen = [&](vtkIdType block)
      { return blocks.IsSeen(static_cast<std::size_t>(block)); };
      for (vtkIdType block = begin; block < end; ++block)
      {
        const auto first = static_cast<int>(block) * Size;
        while (block < end && isSeen(block))
        {
          ++block;
        }
        const int last = std::min(static_cast<int>(block) * Size, faces);
        if (first < last)
        {
          HWY_DYNAMIC_DISPATCH(CellProjectionTiles::ProjectFaces)
          (mesh, view, vertices, bounds, first, last, *this);
        }
      }
    });
}
#endif
