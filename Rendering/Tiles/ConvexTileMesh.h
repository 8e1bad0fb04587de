/**
 * Convex cells as the tiles read them: faces as triangles, shared faces once.
 *
 * A scalar is linear on each triangle of a face and along a ray between the faces where it enters
 * and leaves a cell. Short runs of cells follow each other along a curve (MortonOrder); faces and points
 * keep the numbers that they were given.
 */
#ifndef ConvexTileMesh_h
#define ConvexTileMesh_h

#include "CellPlanes.h"
#include "ConvexCellFaces.h"
#include "FacePieces.h"

#include <array>
#include <cstddef>
#include <vector>

class ConvexTileMesh
{
public:
  /** `points`: x, y, z and an unused fourth each. `pieces` are read from frame to frame and must
   *  outlive this mesh. */
  void Build(const std::vector<float>& points, const ConvexCellFaces& cells,
    const FacePieces& pieces, const CellPlanes& planes);

  /** One per point or per cell as given; `sign` -1 turns greatest into least. */
  void SetScalars(const std::vector<float>& values, bool onePerCell, float sign);

  /** Ids as given of the cells to be seen; flat ones are left out. False where they are those of before. */
  bool SetDrawn(const std::vector<unsigned int>& cells);

  int GetNumberOfCells() const { return this->Corners.GetNumberOfRows(); }
  int GetNumberOfFaces() const { return static_cast<int>(this->FaceKinds.size()); }
  std::size_t GetMemorySize() const;

  /** The greatest scalar of a cell's corners. */
  float FindGreatest(int cell) const;

  /** Which of the given cells each one is. */
  std::vector<int> Source;
  /** Points and faces per cell. */
  ConvexCellFaces::Rows Corners, Faces;
  /** Per cell: the edges of its faces' pieces, which corners of the cell they join. None where there are
   *  more than MostCorners or MostEdges. */
  struct EdgeRows
  {
    std::vector<int> Offsets{ 0 };
    std::vector<std::array<unsigned char, 2>> Ends;
  };
  EdgeRows Edges;
  static constexpr int MostCorners = 32;
  static constexpr int MostEdges = 64;
  /** Of a cell of planes on the screen. */
  static constexpr int MostFaces = 32;
  const FacePieces* Pieces = nullptr;
  /** x, y, z, scalar. */
  std::vector<float> Points;
  /** Empty where scalars are the points'. */
  std::vector<float> CellScalars;
  /** Per face of each cell, in the order of Faces: 1 where the face's normal points into the
   *  cell, -1 where out of it. */
  std::vector<signed char> Sides;
  /** Per face, bit by bit. */
  enum FaceKind : unsigned char
  {
    /** The scalar may step there, or the mesh ends. */
    Step = 1,
    TwoTriangles = 2,
    /** The two lie in planes of their own. */
    Warped = 4,
    MoreTriangles = 8
  };
  std::vector<unsigned char> FaceKinds;
  std::vector<unsigned char> Drawn;

private:
  void OrderCells(const ConvexCellFaces::Rows& corners);
  static void CopyRows(
    const ConvexCellFaces::Rows& from, const std::vector<int>& rows, ConvexCellFaces::Rows& to);
  void FindSides(const CellPlanes& planes);
  void FindFaceKinds();
  void FindSteps();
  void FindEdges();
  void AddEdges(int cell);

  /** Per cell: whether its points span a volume. */
  std::vector<unsigned char> IsSolid;
};

#endif
