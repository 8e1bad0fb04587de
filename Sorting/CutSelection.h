/**
 * Chooses the plane by which a concave part of an exterior volume is cut.
 *
 * Paper: Roettger et al. 2004, section 6.2: a plane through a face at a concave edge, so that the
 * cut removes a concavity; of a few that are drawn by lot, the one that splits the fewest faces.
 * The lot is the same in every run.
 */
#ifndef CutSelection_h
#define CutSelection_h

#include <random>
#include <vector>

class ExteriorGeometry;
struct ExteriorPart;

class CutSelection
{
public:
  CutSelection(const ExteriorGeometry& geometry, int numberOfCandidates);

  /** A plane; -1 where the part is convex. */
  int Choose(const ExteriorPart& part);

private:
  std::vector<int> FindPlanesAtConcaveEdges(const ExteriorPart& part) const;
  std::vector<int> FindPlanesWithPointsOutside(const ExteriorPart& part) const;
  bool CanCut(const ExteriorPart& part, int plane) const;

  const ExteriorGeometry& Geometry;
  int NumberOfCandidates;
  std::mt19937 Random;
};

#endif
