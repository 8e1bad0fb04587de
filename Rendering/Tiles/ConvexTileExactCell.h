/**
 * One convex cell between whose planes a ray is inside, set up in double from its points.
 *
 * For the cells that floats on the screen do not serve: those that reach the near or the far plane
 * or behind the eye, with a face that is seen almost edge-on or whose two triangles face different
 * ways, or on which the scalar changes faster than a float's step. Any eye will do, inside the cell
 * too. The rules are those of the Raster engine (cpConvexCell.glsl, cpValley.glsl, cpFaceScalar.glsl).
 */
#ifndef ConvexTileExactCell_h
#define ConvexTileExactCell_h

#include <glm/vec3.hpp>

#include <array>
#include <vector>

class ConvexTileMesh;
class ConvexTileRays;
class TileView;

class ConvexTileExactCell
{
public:
  /** Memory is kept from cell to cell. */
  void SetUp(const ConvexTileMesh& mesh, int cell);

  /** Depths from the plane through the mesh's centre, scalars at both ends. */
  struct Segment
  {
    double Entry, Exit;
    double ScalarIn, ScalarOut;
  };
  /** Between the near and the far plane; false where the ray misses the cell. */
  bool Cross(const ConvexTileRays& rays, double x, double y, Segment& segment) const;

  /** First and last pixel column, first and last row that a cell may cover; empty where last <
   *  first. */
  static std::array<int, 4> FindBox(const ConvexTileMesh& mesh, const TileView& view, int cell);

  /** Sine of the angle below which a ray runs along a plane, and the height that is rounding there. */
  static constexpr double Rounding = 1e-12;
  static constexpr double FarAway = 1e30;
  /** In pixels: rounding must not keep a pixel from a cell in double. */
  static constexpr double Margin = 1.0 / 64.0;

  /** Inside where Normal . (x - Center) + Offset > 0. */
  struct Plane
  {
    glm::dvec3 Normal;
    double Offset;
    /** To which side a ray along the plane counts as moved. */
    double Nudge;
    int Piece;
  };
  /** See class FacePieces. */
  struct Piece
  {
    glm::dvec3 First, GradientU, GradientW;
    double U1, U3, W1;
    std::array<glm::dvec3, 4> Corners;
    std::array<double, 4> Scalars;
    bool HasTwo, GoesOn;
  };
  glm::dvec3 Center{ 0.0 };
  std::vector<Plane> Planes;
  /** Pairs: inside either is inside. */
  std::vector<Plane> Valleys;
  std::vector<Piece> Pieces;
  bool HasCellScalar = false;
  double CellScalar = 0.0;

private:
  /** Depths beside the cell's centre, and the planes of both ends. */
  struct Passage
  {
    glm::dvec3 Place, Direction;
    double Depths[2];
    const Plane* Planes[2];
    double Parallel;
  };

  void AddFace(const ConvexTileMesh& mesh, int face, bool isInward);
  void AddPieces(const ConvexTileMesh& mesh, int face);
  static void CutAtPlane(const Plane& plane, Passage& passage);
  static void CutAtValley(const Plane* planes, Passage& passage);
  double ScalarOnFace(int piece, const glm::dvec3& point, const glm::dvec3& direction) const;
  static bool FindScalar(const Piece& piece, int second, const glm::dvec3& point,
    const glm::dvec3& direction, double& scalar);
};

#endif
