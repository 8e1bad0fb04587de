/**
 * Cuts a part of an exterior volume in two by a plane.
 *
 * Paper: Roettger et al. 2004, section 6.1, steps 3 and 4: faces go to their side, those that cross
 * the plane are split, and the section is closed on both sides by the same polygons.
 */
#ifndef ExteriorCut_h
#define ExteriorCut_h

#include "ExteriorPart.h"
#include "PlaneDivision.h"

#include <map>
#include <utility>

class ExteriorCut
{
public:
  /** `cut` names the faces of the section. */
  ExteriorCut(ExteriorGeometry& geometry, int plane, int cut);

  /** `below` gets what lies on the negative side. Either may stay without faces. */
  void Run(const ExteriorPart& part, ExteriorPart& below, ExteriorPart& above);

  /** Faces of `part` that the plane would split. */
  static int CountSplits(const ExteriorGeometry& geometry, const ExteriorPart& part, int plane);

private:
  void Distribute(const ExteriorFace& face, ExteriorPart& below, ExteriorPart& above);
  ExteriorFace Clip(const ExteriorFace& face, int side);
  int FindIntersection(int from, int to);
  /** The edges of a half that lie in the plane, turned round or not, and how far they are from
   *  closed. */
  PlaneDivision FindOutline(const ExteriorPart& half, bool turned, double& gap) const;
  void Close(ExteriorPart& below, ExteriorPart& above);

  ExteriorGeometry& Geometry;
  int Plane;
  int Cut;
  std::map<std::pair<int, int>, int> Intersections;
};

#endif
