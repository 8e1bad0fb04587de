/**
 * A part of an exterior volume: polygons, some of them the mesh's boundary seen from outside.
 */
#ifndef ExteriorPart_h
#define ExteriorPart_h

#include <vector>

class ExteriorGeometry;

/** A convex polygon in a plane; what lies across it follows from where it comes from. */
struct ExteriorFace
{
  /** Counter-clockwise seen from outside the part; ids of ExteriorGeometry. */
  std::vector<int> Corners;
  int Plane = -1;
  /** 1 where the plane's normal points out of the part, -1 where it points into it. */
  int Direction = 1;
  /** The boundary triangle of the mesh that it is a piece of, or -1. */
  int Triangle = -1;
  /** The cut that made it, or -1; with neither it belongs to the enclosure. */
  int Cut = -1;
};

struct ExteriorPart
{
  std::vector<ExteriorFace> Faces;
  /** Planes that have cut it, ascending: none cuts twice, so the cutting ends. */
  std::vector<int> UsedPlanes;

  /** Negative for the boundary of a hole. */
  double GetVolume(const ExteriorGeometry& geometry) const;
  /** Components that share no point. Those that are not closed edge by edge stay together, for they
   *  may close each other; and all of them do where one is the boundary of a hole in another. */
  std::vector<ExteriorPart> Separate(const ExteriorGeometry& geometry) const;
  /** Ids of all corners, ascending. */
  std::vector<int> GetPoints() const;
  bool HasUsed(int plane) const;

private:
  bool IsClosed() const;
  std::vector<ExteriorPart> FindComponents() const;
};

#endif
