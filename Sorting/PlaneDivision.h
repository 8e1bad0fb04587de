/**
 * What directed edges in a plane enclose, as convex faces of a part.
 */
#ifndef PlaneDivision_h
#define PlaneDivision_h

#include "ExteriorPart.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

class ExteriorGeometry;

class PlaneDivision
{
public:
  /** An edge that is added in both directions bounds nothing. */
  void AddEdge(int from, int to)
  {
    this->Edges[{ std::min(from, to), std::max(from, to) }] += from < to ? 1 : -1;
  }

  /** Faces to the left of the edges, seen against the plane's normal; all else as in `pattern`. */
  std::vector<ExteriorFace> Run(ExteriorGeometry& geometry, const ExteriorFace& pattern) const;

private:
  /** Of a pair of points in ascending order: how often it runs from the first to the second. */
  std::map<std::pair<int, int>, int> Edges;
};

#endif
