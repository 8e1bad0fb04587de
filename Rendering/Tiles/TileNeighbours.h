/**
 * Which tetrahedra share a face.
 *
 * Faces are scattered by their smallest point and sorted within one point's: linear for meshes
 * whose points have few cells. Of three cells at one face two become neighbours.
 */
#ifndef TileNeighbours_h
#define TileNeighbours_h

#include <vector>

namespace TileNeighbours
{
/** `corners`: 4 ascending point ids per cell. Per cell the neighbour across the face opposite each
 *  corner; -1 where there is none. */
std::vector<int> Find(const std::vector<int>& corners, int numberOfPoints);
}

#endif
