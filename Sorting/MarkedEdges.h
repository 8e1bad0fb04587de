/**
 * Edges of tetrahedra that are to be halved, and the tetrahedra cut up so that neighbours agree.
 *
 * A tetrahedron is halved at its marked edge that comes first, then its halves are, until none has
 * a marked edge. Which comes first is the edge's own affair: the mark of an earlier pass, the
 * longer edge, the smaller ids. So two tetrahedra that share a face cut it alike, whatever their
 * other edges ask for (Rivara's bisection, with the refinement of a face decided by its own edges).
 */
#ifndef MarkedEdges_h
#define MarkedEdges_h

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <unordered_map>

class MarkedEdges
{
public:
  /** A piece of a cell: point ids, and where they are in the cell. */
  struct Tetrahedron
  {
    std::array<vtkIdType, 4> Ids;
    std::array<std::array<double, 3>, 4> References;
    vtkIdType Cell = -1;
    bool Curved = false;
    bool Settled = false; // found to be straight
  };

  static constexpr int Ends[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };

  /** False where the edge is known already. */
  bool Insert(vtkIdType a, vtkIdType b) { return this->Edges.emplace(KeyOf(a, b), Edge{}).second; }

  bool IsMarked(vtkIdType a, vtkIdType b) const { return this->Find(a, b) != nullptr; }
  /** -1 where it is not marked. */
  vtkIdType GetMiddle(vtkIdType a, vtkIdType b) const
  {
    const Edge* edge = this->Find(a, b);
    return edge ? edge->Middle : -1;
  }
  /** `middle`: the id of the point that halves it. */
  void Mark(vtkIdType a, vtkIdType b, vtkIdType middle, int pass, double length)
  {
    this->Edges[KeyOf(a, b)] = { middle, pass, length };
  }

  /** keep(tetrahedron) for each piece, or for itself where no edge is marked. */
  template <typename Keep>
  void Cut(const Tetrahedron& tetrahedron, Keep& keep) const
  {
    const int first = this->FindFirst(tetrahedron);
    if (first < 0)
    {
      keep(tetrahedron);
      return;
    }
    for (const int end : Ends[first])
    {
      Tetrahedron half = tetrahedron;
      this->Halve(first, end, half);
      this->Cut(half, keep);
    }
  }

private:
  using Key = std::array<vtkIdType, 2>;
  struct Edge
  {
    vtkIdType Middle = -1;
    int Pass = 0;
    double Length = 0.0;
  };
  struct Hash
  {
    std::size_t operator()(const Key& key) const
    {
      auto mixed = static_cast<unsigned long long>(key[0]) * 0x9E3779B97F4A7C15ull;
      mixed = (mixed ^ (mixed >> 32) ^ static_cast<unsigned long long>(key[1])) *
              0xD6E8FEB86659FD93ull;
      return static_cast<std::size_t>(mixed ^ (mixed >> 32));
    }
  };

  static Key KeyOf(vtkIdType a, vtkIdType b) { return { std::min(a, b), std::max(a, b) }; }
  const Edge* Find(vtkIdType a, vtkIdType b) const;
  int FindFirst(const Tetrahedron& tetrahedron) const;
  void Halve(int edge, int end, Tetrahedron& tetrahedron) const;

  std::unordered_map<Key, Edge, Hash> Edges;
};

#endif
