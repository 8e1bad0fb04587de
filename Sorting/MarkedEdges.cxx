#include "MarkedEdges.h"

#include <tuple>

const MarkedEdges::Edge* MarkedEdges::Find(vtkIdType a, vtkIdType b) const
{
  const auto found = this->Edges.find(KeyOf(a, b));
  return found != this->Edges.end() && found->second.Middle >= 0 ? &found->second : nullptr;
}

int MarkedEdges::FindFirst(const Tetrahedron& tetrahedron) const
{
  using Rank = std::tuple<int, double, Key>;
  int first = -1;
  Rank lowest;
  for (int edge = 0; edge < 6; ++edge)
  {
    const vtkIdType a = tetrahedron.Ids[Ends[edge][0]], b = tetrahedron.Ids[Ends[edge][1]];
    if (const Edge* marked = this->Find(a, b))
    {
      const Rank rank{ marked->Pass, -marked->Length, KeyOf(a, b) };
      if (first < 0 || rank < lowest)
      {
        first = edge;
        lowest = rank;
      }
    }
  }
  return first;
}

void MarkedEdges::Halve(int edge, int end, Tetrahedron& tetrahedron) const
{
  const int a = Ends[edge][0], b = Ends[edge][1];
  const vtkIdType middle = this->Find(tetrahedron.Ids[a], tetrahedron.Ids[b])->Middle;
  const auto from = tetrahedron.References[a], to = tetrahedron.References[b];
  tetrahedron.Ids[end] = middle;
  for (int axis = 0; axis < 3; ++axis)
  {
    tetrahedron.References[end][axis] = 0.5 * (from[axis] + to[axis]);
  }
  tetrahedron.Settled = false;
}
