#ifndef BoxTree_h
#define BoxTree_h

#include <functional>
#include <vector>

/// Boxes in a binary tree: which of them a line may meet. Never misses one.
class BoxTree
{
public:
  struct Box
  {
    double Low[3];
    double High[3];
  };

  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls `found` with the number of every box near the whole line through `origin`.
  void ForEachNear(
    const double origin[3], const double direction[3], const std::function<void(int)>& found) const;

private:
  struct Node
  {
    Box Bounds;
    int Begin, End; // in Members
    int Second;     // the second child; the first follows; 0 for a leaf
  };
  void Build(const std::vector<Box>& boxes, int begin, int end);
  Box BoundsOf(const std::vector<Box>& boxes, int begin, int end) const;

  std::vector<Node> Nodes;
  std::vector<int> Members;
};

#endif
