/**
 * Convex cells that fill what a mesh leaves out of its hull or box.
 *
 * Paper: Roettger, Guthe, Schieber, Ertl, Convexification of Unstructured Grids, 2004, section 6:
 * the exterior volume is cut by planes through its own concave faces until every part is convex and
 * connected. The mesh itself is never cut; its boundary triangles may touch several of the cells.
 *
 * Every plane is that of three points of the mesh, so that the contacts of the cells have exact
 * signs too.
 */
#ifndef Convexification_h
#define Convexification_h

#include "CellComplex.h"

#include <functional>
#include <vector>

/** Convex cells that sort and are never drawn; numbered on from the cells of the mesh. */
struct ImaginaryCells
{
  /** Three per point; their ids go on from the points of the mesh. */
  std::vector<double> Points;
  /** Corners of all faces, one after the other, counter-clockwise seen from outside the cell. */
  std::vector<int> FaceCorners;
  /** Where each face begins in FaceCorners, and the end. */
  std::vector<int> FaceOffsets{ 0 };
  /** Which faces are whose: where each cell begins in FaceOffsets, and the end. */
  std::vector<int> CellOffsets{ 0 };
  /** Each cell has four triangles. */
  bool AreTetrahedra = false;
  /** Where a cell touches the mesh or another of these cells; points are those of the mesh. */
  std::vector<CellComplex::Contact> Contacts;

  int GetNumberOfCells() const { return static_cast<int>(this->CellOffsets.size()) - 1; }
};

struct ConvexificationSettings
{
  /** Fill the convex hull; else a box about the mesh. */
  bool ConvexHull = true;
  /** Leave out the cells that lie outside of the convex hull (a box has many). */
  bool DiscardOutsideHull = true;
  /** Cutting planes compared for each cut: 1 .. 20 and more. */
  int NumberOfCandidateCuts = 20;
  /** Called with 0 .. 1; false ends the work. */
  std::function<bool(double)> Progress;
};

struct ConvexificationResult
{
  ImaginaryCells Cells;
  int NumberOfDiscardedCells = 0;
  double DiscardedVolume = 0.0;
  double ImaginaryVolume = 0.0;
  /** Of the hull or the box. */
  double EnclosureVolume = 0.0;
  /** What the cells lack or have too much of the exterior volume, as a share of the enclosure's:
   *  rounding, unless the boundary of the mesh runs through itself. */
  double VolumeError = 0.0;
  /** True where the mesh fills its hull already. */
  bool IsConvex = false;
  bool Aborted = false;
};

namespace Convexification
{
ConvexificationResult Run(const CellComplex& mesh, const ConvexificationSettings& settings);
}

#endif
