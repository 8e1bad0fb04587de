/**
 * Mesh coordinates to the screen, and what else depends on the eye alone.
 *
 * On the screen a point has the pixel coordinates x and y (whole numbers are pixel centres) and u,
 * which grows towards the eye: 1 / depth in perspective, minus the depth in parallel projection,
 * both counted from the mesh's centre. The map is projective, so that planes stay planes: of a
 * plane u is linear in x and y, and so is s * weight of a linear scalar s in x, y and u, where
 *
 *     weight(u) = WeightScale * u + WeightOffset      (1 / depth; 1 in parallel projection)
 *
 * Perspective is exact, then. A piece of a ray from u1 down to u2 has the world length
 * (u1 - u2) / (weight(u1) * weight(u2)) * |ray|, where |ray|^2 is a quadratic function of the
 * pixel.
 */
#ifndef TileView_h
#define TileView_h

#include "TileCells.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>

class TileView
{
public:
  struct Camera
  {
    glm::dmat4 MeshToView{ 1.0 };
    glm::dmat4 ViewToClip{ 1.0 };
    glm::dmat4 ViewToWorld{ 1.0 };
    int Width = 1;
    int Height = 1;

    bool operator==(const Camera& other) const;
  };

  /** False where nothing can be seen: a matrix without an inverse, or without a near or a far plane. */
  bool Build(const Camera& camera);

  /** u at a depth from the view's origin. */
  double ScreenDepth(double depth) const;
  /** 1 / (Terms[0] + Terms[1] * depth) + Terms[2] where InPerspective, else Terms[0] + Terms[1] *
   *  depth: as ScreenDepth where that is before the eye, for those who have many depths. */
  struct DepthToScreen
  {
    std::array<double, 3> Terms;
    bool InPerspective;
  };
  DepthToScreen GetDepthToScreen() const;
  /** Depth from the view's origin of a window depth in [0, 1]. */
  double DepthOfWindow(double z) const;

  /** Homogeneous: x h, y h, u h, h; h is positive before the eye. */
  glm::dmat4 MeshToScreen{ 1.0 };
  /** Planes and linear functions: rows times the inverse, written as columns. */
  glm::dmat4 PlaneToScreen{ 1.0 };
  glm::dmat4 ViewPlaneToScreen{ 1.0 };
  /** Whether a cell keeps its orientation on the screen. */
  bool KeepsOrientation = true;
  double WeightScale = 0.0, WeightOffset = 1.0;
  /** Near and far plane. */
  double NearU = 0.0, FarU = 0.0;
  /** How deep the mesh is at most, along the view axis and as a world length along a ray; the
   *  weight of its far end. */
  double Extent = 0.0, LengthOfExtent = 0.0, FarWeight = 1.0;
  int Width = 1, Height = 1;
  /** Tiles have 1 << RowShift rows; Build leaves that alone. */
  int RowShift = TileSize::Shift;

  /** The direction of a ray in the world per depth, at pixel 0, 0; its change in x and in y. */
  std::array<glm::dvec3, 3> Ray;

private:
  void SetDepths(const glm::dmat4& meshToView, double nearDepth, double farDepth);
  void SetScreen(const Camera& camera);
  void SetRays(const Camera& camera);

  glm::dmat4 ViewToClip{ 1.0 };
  double Reference = 0.0;
  bool IsParallel = false;
};

#endif
