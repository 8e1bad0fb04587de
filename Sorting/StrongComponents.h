/**
 * The strongly connected components of a directed graph, in linear time.
 *
 * Method: Tarjan, Depth-First Search and Linear Graph Algorithms, 1972, without recursion. A
 * component is given out after all that its edges lead to. Whoever takes one may take nodes out of
 * the graph: they belong to no component then.
 */
#ifndef StrongComponents_h
#define StrongComponents_h

#include <algorithm>
#include <vector>

class StrongComponents
{
public:
  /** Forgets what was seen before. */
  void Reset(int numberOfNodes)
  {
    for (const int node : this->Seen)
    {
      this->Index[node] = Unseen;
    }
    this->Seen.clear();
    this->Index.resize(static_cast<size_t>(numberOfNodes), Unseen);
    this->Low.resize(static_cast<size_t>(numberOfNodes), 0);
    this->Next = 0;
  }

  /** Walks from `root` over all nodes not seen before. `getEdge(node, k)`: the target of edge k, -1
   *  for one that does not count, -2 after the last. `isGone(node)`: whether it was taken out of
   *  the graph. `take(component)`: gets the nodes. */
  template <typename GetEdge, typename IsGone, typename Take>
  void Walk(int root, const GetEdge& getEdge, const IsGone& isGone, const Take& take)
  {
    this->Enter(root);
    while (!this->Path.empty())
    {
      const int node = this->Path.back().Node;
      if (isGone(node))
      {
        this->Path.pop_back();
        continue;
      }
      const int target = getEdge(node, this->Path.back().Edge);
      if (target == -2)
      {
        this->Leave(node, isGone, take);
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
    this->Open.clear();
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
    this->Seen.push_back(node);
    this->Open.push_back(node);
    this->Path.push_back({ node, 0 });
  }

  template <typename IsGone, typename Take>
  void Leave(int node, const IsGone& isGone, const Take& take)
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
    component.erase(std::remove_if(component.begin(), component.end(), isGone), component.end());
    take(component);
  }

  std::vector<int> Index;
  std::vector<int> Low;
  std::vector<int> Seen;
  std::vector<int> Open;
  std::vector<Step> Path;
  int Next = 0;
};

#endif
