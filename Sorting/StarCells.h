/**
 * The cells of a mesh that are cut from a point within, StarCell, and these points.
 *
 * A point's data are those of the cell's corners by mean value coordinates, so that a linear field
 * stays linear.
 */
#ifndef StarCells_h
#define StarCells_h

#include "ConvexCellPlan.h"
#include "StarCell.h"

#include <map>
#include <mutex>
#include <vector>

class ConvexCellPoints;
class vtkIdList;

class StarCells
{
public:
  /** Cuts the cell, if a point within sees all of it; then its plan says so. From any thread.
   *  `sign`: -1 where it is inside out. `points`, of its vertices, are not scaled. */
  void Try(vtkIdType cell, const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
    const double (*points)[3], double sign, const ConvexCellPoints& mesh, ConvexCellPlan& plan,
    ConvexCellCursor& cursor);

  /** At once: adds the point, and the ids of the tetrahedra to `pieces`, however the cell is wound. To
   *  be tried again later, it keeps that point. Not from several threads. */
  bool Split(vtkIdType cell, const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
    const double (*points)[3], ConvexCellPoints& mesh,
    std::vector<std::array<vtkIdType, 4>>& pieces);

  /** After all were tried. */
  void AddPoints(ConvexCellPoints& mesh);

  void Write(vtkIdType cell, const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
    const double (*points)[3], const vtkIdType* outputIds, const ConvexCellArrays& arrays,
    ConvexCellCursor& cursor) const;

  /** False where the cell is not one of them. */
  bool GetWeights(vtkIdType cell, vtkIdList* ids, std::vector<double>& weights) const;

private:
  struct Star
  {
    StarCell::Point Kernel;
    double Sign = 1.0;
    vtkIdType Id = -1;
    std::vector<vtkIdType> Corners;
    std::vector<double> Weights;
  };
  static bool Find(const StarCell::Triangles& triangles, const vtkIdType* ids,
    const double (*points)[3], int count, const ConvexCellPoints& mesh, Star& star);

  std::map<vtkIdType, Star> Stars; // by cell
  std::mutex Mutex;
};

#endif
