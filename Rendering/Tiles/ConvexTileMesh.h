/**
 * Convex cells as the tiles read them: faces as triangles, shared faces once.
 *
 * A scalar is linear on each triangle of a face and along a ray between the faces where it enters
 * and leaves a cell. Cells and faces keep the numbers that they were given.
 */
#ifndef ConvexTileMesh_h
#define ConvexTileMesh_h

#include "CellPlanes.h"
#include "ConvexCellFaces.h"
#include "FacePieces.h"

#include <cstddef>
#include <vector>

class ConvexTileMesh
{
public:
  /** `points`: x, y, z and an unused fourth each. The others are read from frame to frame and must
   *  outlive this mesh. */
  void Build(const std::vector<float>& points, const ConvexCellFaces& cells,
    const FacePieces& pieces, const CellPlanes& planes);

  /** One per point or per cell; `sign` -1 turns greatest into least. */
  void SetScalars(const std::vector<float>& values, bool onePerCell, float sign);

  /** Ids of the cells to be seen; flat ones are left out. */
  void SetDrawn(const std::vector<unsigned int>& cells);

  int GetNumberOfCells() const { return this->Cells ? this->Cells->GetNumberOfCells() : 0; }
  std::size_t GetMemorySize() const;

  /** The greatest scalar of a cell's corners. */
  float FindGreatest(int cell) const;

  const ConvexCellFaces* Cells = nullptr;
  const FacePieces* Pieces = nullptr;
  /** x, y, z, scalar. */
  std::vector<float> Points;
  /** Empty where scalars are the points'. */
  std::vector<float> CellScalars;
  /** Per face of each cell, in the order of Cells->Faces: 1 where the face's normal points into the
   *  cell, -1 where out of it. */
  std::vector<signed char> Sides;
  /** Per face: whether the scalar may step there, or the mesh ends. */
  std::vector<unsigned char> Steps;
  std::vector<unsigned char> Drawn;

private:
  void FindSides(const CellPlanes& planes);
  void FindSteps();

  /** Per cell: whether its points span a volume. */
  std::vector<unsigned char> IsSolid;
};

#endif
