/**
 * On which side of a closed surface tetrahedra lie that have every triangle of it among their
 * faces.
 */
#ifndef TetrahedraSides_h
#define TetrahedraSides_h

#include <array>
#include <vector>

namespace TetrahedraSides
{
/** Exchanges two corners where the volume is negative. */
void TurnPositive(const std::vector<double>& points, std::array<int, 4>& tetrahedron);

/**
 * Keeps the tetrahedra inside (else those outside) of `surface`, whose triangles turn
 * counter-clockwise seen from outside. False where a triangle is no face of theirs, or a
 * tetrahedron lies on both sides: the surface does not enclose anything.
 */
bool Keep(const std::vector<std::array<int, 3>>& surface, bool inside,
  std::vector<std::array<int, 4>>& tetrahedra);
}

#endif
