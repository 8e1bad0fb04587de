/**
 * The strongly connected components of a directed graph, in linear time.
 *
 * Method: Tarjan, Depth-First Search and Linear Graph Algorithms, 1972, without recursion. A
 * component is given out after all that its edges lead to.
 */
#ifndef StrongComponents_h
#define StrongComponents_h

#include <algorithm>
#include <vector>

class StrongComponents
{
public:
  explicit StrongComponents(int numberOfNodes)
    : Index(static_cast<size_t>(numberOfNodes), Unseen)
    , Low(static_cast<size_t>(numberOfNodes), 0)
  {
  }

  /** Walks from `root` over all nodes not seen before. `getEdge(node, k)`: the target of edge k, -1
   *  for one that does not count, -2 after the last. `take(component)`: gets the nodes. */
  template <typename GetEdge, typename Take>
  void Walk(int root, const GetEdge& getEdge, const Take& take)
  {
    this->Enter(root);
    while (!this->Path.empty())
    {
      const int node = this->Path.back().Node;
      const int target = this->Index[node] == Done ? -2 : getEdge(node, this->Path.back().Edge);
      if (target == -2)
      {
        this->Leave(node, take);
        continue;
      }
      ++this->Path.back().Edge;
      if (target >= 0 && this->Index[target] == Unseen)
      {
        this->Enter(target);
      }
      else if (target >= 0 && this->Index[target] != Done)
      {
        this->Low[node] = std::min(this->Low[node], this->Index[target]);
      }
    }
  }

  bool HasSeen(int node) const { return this->Index[node] != Unseen; }

private:
  static constexpr int Unseen = -1;
  static constexpr int Done = -2;

  struct Step
  {
    int Node;
    int Edge;
  };

  void Enter(int node)
  {
    this->Index[node] = this->Low[node] = this->Next++;
    this->Open.push_back(node);
    this->Path.push_back({ node, 0 });
  }

  template <typename Take>
  void Leave(int node, const Take& take)
  {
    this->Path.pop_back();
    if (!this->Path.empty())
    {
      int& low = this->Low[this->Path.back().Node];
      low = std::min(low, this->Low[node]);
    }
    if (this->Low[node] != this->Index[node])
    {
      return;
    }
    const auto begin = std::find(this->Open.rbegin(), this->Open.rend(), node).base() - 1;
    std::vector<int> component(begin, this->Open.end());
    this->Open.erase(begin, this->Open.end());
    for (const int member : component)
    {
      this->Index[member] = Done;
    }
    take(component);
  }

  std::vector<int> Index;
  std::vector<int> Low;
  std::vector<int> Open;
  std::vector<Step> Path;
  int Next = 0;
};

#endif
