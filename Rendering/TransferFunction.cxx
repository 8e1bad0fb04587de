#include "TransferFunction.h"

#include <algorithm>
#include <cmath>

namespace
{
// Intervals are not halved below 2^-16 of their width: a float position would not tell the halves
// apart.
constexpr int MaximumDepth = 16;

double Difference(const TransferFunction::Sample& a, const TransferFunction::Sample& b)
{
  double difference = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    difference = std::max(difference, std::abs(a[i] - b[i]));
  }
  return difference;
}

TransferFunction::Sample Mix(
  const TransferFunction::Sample& a, const TransferFunction::Sample& b, double weight)
{
  TransferFunction::Sample mixed;
  for (int i = 0; i < 4; ++i)
  {
    mixed[i] = a[i] + weight * (b[i] - a[i]);
  }
  return mixed;
}
}

//------------------------------------------------------------------------------
void TransferFunction::Build(std::vector<double> candidates, const Evaluator& evaluate,
  const double range[2], double unitDistance)
{
  const double low = range[0];
  const double high = range[1];
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                     [=](double scalar) { return !(scalar > low && scalar < high); }),
    candidates.end());
  candidates.push_back(low);
  candidates.push_back(high);
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());

  // One-sided limits are taken just beside a candidate, farther than its own rounding.
  const double magnitude = std::max(std::abs(low), std::abs(high));
  const double step = std::max(1e-11 * (high - low), 1e-15 * magnitude);
  this->Nodes.clear();
  for (size_t i = 0; i < candidates.size(); ++i)
  {
    this->AppendJoint(candidates[i], step, i == 0, i + 1 == candidates.size(), evaluate);
  }
  this->Store(range, unitDistance);
  this->CountVisible();
}

//------------------------------------------------------------------------------
void TransferFunction::AppendJoint(
  double scalar, double step, bool first, bool last, const Evaluator& evaluate)
{
  const Node below{ scalar, evaluate(first ? scalar : scalar - step) };
  const Node above{ scalar, evaluate(last ? scalar : scalar + step) };
  if (!first)
  {
    const Node previous = this->Nodes.back();
    this->Refine(previous, below, 0, evaluate);
    this->Nodes.push_back(below);
  }
  if (first || (!last && Difference(below.Value, above.Value) > Tolerance))
  {
    this->Nodes.push_back(above);
  }
}

//------------------------------------------------------------------------------
void TransferFunction::Refine(
  const Node& low, const Node& high, int depth, const Evaluator& evaluate)
{
  auto scalarAt = [&](double weight) { return low.Scalar + weight * (high.Scalar - low.Scalar); };
  double error = 0.0;
  for (const double weight : { 0.25, 0.5, 0.75 })
  {
    const Sample chord = Mix(low.Value, high.Value, weight);
    error = std::max(error, Difference(chord, evaluate(scalarAt(weight))));
  }
  if (depth >= MaximumDepth || !(error > Tolerance))
  {
    return;
  }
  const Node middle{ scalarAt(0.5), evaluate(scalarAt(0.5)) };
  this->Refine(low, middle, depth + 1, evaluate);
  this->Nodes.push_back(middle);
  this->Refine(middle, high, depth + 1, evaluate);
}

//------------------------------------------------------------------------------
void TransferFunction::Store(const double range[2], double unitDistance)
{
  const double width = range[1] - range[0];
  this->Positions.clear();
  this->Values.clear();
  for (const Node& node : this->Nodes)
  {
    const double position = width > 0.0 ? (node.Scalar - range[0]) / width : 0.0;
    this->Positions.push_back(static_cast<float>(position));
    for (int i = 0; i < 3; ++i)
    {
      this->Values.push_back(static_cast<float>(node.Value[i]));
    }
    this->Values.push_back(static_cast<float>(std::max(node.Value[3], 0.0) / unitDistance));
  }
  if (this->Positions.size() == 1)
  {
    // A constant field still needs one interval.
    this->Positions.push_back(1.0f);
    const std::array<float, 4> only{ this->Values[0], this->Values[1], this->Values[2],
      this->Values[3] };
    this->Values.insert(this->Values.end(), only.begin(), only.end());
  }
}

//------------------------------------------------------------------------------
void TransferFunction::CountVisible()
{
  const int intervals = this->GetNumberOfNodes() - 1;
  this->VisibleBefore.assign(intervals + 1, 0);
  for (int i = 0; i < intervals; ++i)
  {
    const bool visible = this->Values[4 * i + 3] > 0.0f || this->Values[4 * i + 7] > 0.0f;
    this->VisibleBefore[i + 1] = this->VisibleBefore[i] + (visible ? 1 : 0);
  }
}

//------------------------------------------------------------------------------
bool TransferFunction::IsTransparent(float low, float high) const
{
  const auto begin = this->Positions.begin();
  const auto end = this->Positions.end();
  const int intervals = this->GetNumberOfNodes() - 1;
  // Intervals that touch [low, high], their end points included.
  int first = static_cast<int>(std::lower_bound(begin, end, low) - begin) - 1;
  int last = static_cast<int>(std::upper_bound(begin, end, high) - begin);
  first = std::min(std::max(first, 0), intervals);
  last = std::min(std::max(last, first), intervals);
  return this->VisibleBefore[last] == this->VisibleBefore[first];
}
