#ifndef BoxTree_h
#define BoxTree_h

#include <algorithm>
#include <functional>
#include <vector>

/// Boxes in a binary tree: which of them lines may meet. Never misses one.
class BoxTree
{
public:
  struct Box
  {
    double Low[3] = { 1e300, 1e300, 1e300 };
    double High[3] = { -1e300, -1e300, -1e300 };

    void Add(const double point[3])
    {
      for (int i = 0; i < 3; ++i)
      {
        this->Low[i] = std::min(this->Low[i], point[i]);
        this->High[i] = std::max(this->High[i], point[i]);
      }
    }
    /// Whether they share more than their sides.
    bool Overlaps(const Box& other) const
    {
      bool overlaps = true;
      for (int i = 0; i < 3; ++i)
      {
        overlaps = overlaps && this->Low[i] < other.High[i] && other.Low[i] < this->High[i];
      }
      return overlaps;
    }
  };

  explicit BoxTree(const std::vector<Box>& boxes);

  /// A whole line, as its slabs need it.
  struct Line
  {
    double Origin[3];
    double Inverse[3];

    Line(const double origin[3], const double direction[3]);
  };

  /// Calls `found` with the numbers of every line and every box near it. All lines pass a box
  /// together: it comes from memory once.
  void ForEachNear(
    const std::vector<Line>& lines, const std::function<void(int, int)>& found) const;

private:
  struct Node
  {
    Box Bounds;
    int Begin, End; // in Members
    int Second;     // the second child; the first follows; 0 for a leaf
  };
  void Build(const std::vector<Box>& boxes, int begin, int end);
  struct Search;
  void Visit(int node, std::size_t begin, Search& search) const;
  Box BoundsOf(const std::vector<Box>& boxes, int begin, int end) const;

  std::vector<Node> Nodes;
  std::vector<int> Members;
};

#endif
