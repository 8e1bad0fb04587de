/**
 * Boxes in a balanced binary tree: which of them meet a box.
 *
 * Method: boxes are halved at the median of their middles along the longest axis, down to a few;
 * n log n to build, whatever the boxes' sizes. Queries may run on all threads at once.
 */
#ifndef BoxHierarchy_h
#define BoxHierarchy_h

#include "vtkBoundingBox.h"

#include <vector>

class BoxHierarchy
{
public:
  /** Empty boxes are met by none. */
  explicit BoxHierarchy(std::vector<vtkBoundingBox> boxes);

  /** The numbers of all boxes that share a point with `box`, in no order. */
  void FindMet(const vtkBoundingBox& box, std::vector<int>& met) const;

private:
  void Build(int node, int begin, int end);
  void FindMet(
    int node, int begin, int end, const vtkBoundingBox& box, std::vector<int>& met) const;

  std::vector<vtkBoundingBox> Boxes;
  /** Children of node n are 2n + 1 and 2n + 2. */
  std::vector<vtkBoundingBox> Nodes;
  std::vector<int> Members;
};

#endif
