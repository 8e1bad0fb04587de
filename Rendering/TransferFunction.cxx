#include "TransferFunction.h"

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Bisection ends where float positions do not tell the halves apart, or at the latest after this
// many.
constexpr int MaximumDepth = 60;

// In units of the range: no scalar lies farther out.
constexpr double Beyond = 1e30;

// What a step at the low end is beside by: a float's digits count from zero there.
constexpr float LeastPosition = 1e-24f;

// Times any length that a mesh can have, it stays within the range of a float.
constexpr double MaximumExtinction = 1e18;

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
  const double range[2], const double extremes[2], double unitDistance, Steps steps)
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
  this->Low = low;
  this->Width = high > low ? high - low : 1.0;
  this->Nodes = { { low - Beyond * this->Width, evaluate(extremes[0]) } };
  for (size_t i = 0; i < candidates.size(); ++i)
  {
    const double at = candidates[i];
    const bool isFirst = i == 0, isLast = i + 1 == candidates.size();
    this->AppendJoint({ at, evaluate(isFirst ? extremes[0] : at - step), evaluate(at),
                        evaluate(isLast ? extremes[1] : at + step) },
      steps, evaluate);
  }
  this->Nodes.push_back({ high + Beyond * this->Width, evaluate(extremes[1]) });
  this->Store(unitDistance);
  this->CountVisible();
}

//------------------------------------------------------------------------------
void TransferFunction::AppendJoint(const Joint& joint, Steps steps, const Evaluator& evaluate)
{
  // A limit that is no step is the value itself: beside the end of a ramp it is not quite 0.
  Joint exact = joint;
  for (Sample* limit : { &exact.Below, &exact.Above })
  {
    *limit = Difference(*limit, joint.Here) > Tolerance ? *limit : joint.Here;
  }
  // Beyond the first one the function is constant.
  if (this->Nodes.size() > 1)
  {
    const Node previous = this->Nodes.back();
    this->Refine(previous, { joint.Scalar, exact.Below }, 0, evaluate);
  }
  if (Difference(exact.Below, exact.Here) > 0.0 || Difference(exact.Here, exact.Above) > 0.0)
  {
    this->AppendStep(exact, steps);
  }
  else
  {
    this->Nodes.push_back({ joint.Scalar, joint.Here });
  }
}

//------------------------------------------------------------------------------
void TransferFunction::AppendStep(const Joint& joint, Steps steps)
{
  if (steps == Steps::OfCells)
  {
    this->Nodes.push_back({ joint.Scalar, joint.Below, -StepWidth });
    this->Nodes.push_back({ joint.Scalar, joint.Here, -StepWidth });
    this->Nodes.push_back({ joint.Scalar, joint.Here, StepWidth });
    this->Nodes.push_back({ joint.Scalar, joint.Above, StepWidth });
    return;
  }
  const bool isAbove =
    std::abs(joint.Here[3] - joint.Above[3]) < std::abs(joint.Here[3] - joint.Below[3]) ||
    Difference(joint.Here, joint.Above) == 0.0;
  const float beside = isAbove ? 0.0f : std::numeric_limits<float>::epsilon();
  this->Nodes.push_back({ joint.Scalar, joint.Below, beside });
  this->Nodes.push_back({ joint.Scalar, joint.Above, beside });
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
  const double width = high.Scalar - low.Scalar;
  const double resolution = 1e-7 * std::max(low.Scalar - this->Low, 1e-30 * this->Width);
  if (depth >= MaximumDepth || width <= resolution || !(error > Tolerance))
  {
    return;
  }
  const Node middle{ scalarAt(0.5), evaluate(scalarAt(0.5)) };
  this->Refine(low, middle, depth + 1, evaluate);
  this->Nodes.push_back(middle);
  this->Refine(middle, high, depth + 1, evaluate);
}

//------------------------------------------------------------------------------
void TransferFunction::Store(double unitDistance)
{
  this->Positions.clear();
  this->Values.clear();
  float previous = std::numeric_limits<float>::lowest();
  for (const Node& node : this->Nodes)
  {
    const auto position = static_cast<float>((node.Scalar - this->Low) / this->Width);
    const float beside = node.Beside * std::max(position, LeastPosition);
    // Beside a step there may be another node.
    this->Positions.push_back(std::max(position + beside, previous));
    previous = this->Positions.back();
    for (int i = 0; i < 3; ++i)
    {
      this->Values.push_back(static_cast<float>(node.Value[i]));
    }
    const double extinction = std::max(node.Value[3], 0.0) / unitDistance;
    this->Values.push_back(static_cast<float>(std::min(extinction, MaximumExtinction)));
  }
}

//------------------------------------------------------------------------------
void TransferFunction::CountVisible()
{
  const int intervals = this->GetNumberOfNodes() - 1;
  this->VisibleBefore.assign(intervals + 1, 0);
  this->EmittingBefore.assign(intervals + 1, 0);
  for (int i = 0; i < intervals; ++i)
  {
    const float* node = &this->Values[4 * i];
    const bool visible = node[3] > 0.0f || node[7] > 0.0f;
    const bool coloured = std::any_of(node, node + 3, [](float c) { return c != 0.0f; }) ||
                          std::any_of(node + 4, node + 7, [](float c) { return c != 0.0f; });
    this->VisibleBefore[i + 1] = this->VisibleBefore[i] + (visible ? 1 : 0);
    this->EmittingBefore[i + 1] = this->EmittingBefore[i] + (visible && coloured ? 1 : 0);
  }
}

//------------------------------------------------------------------------------
bool TransferFunction::IsTransparent(float low, float high) const
{
  return this->IsNothing(this->VisibleBefore, low, high);
}

//------------------------------------------------------------------------------
bool TransferFunction::IsDark(float low, float high) const
{
  return this->IsNothing(this->EmittingBefore, low, high);
}

//------------------------------------------------------------------------------
bool TransferFunction::IsNothing(const std::vector<int>& before, float low, float high) const
{
  const auto begin = this->Positions.begin();
  const auto end = this->Positions.end();
  const int intervals = this->GetNumberOfNodes() - 1;
  // Intervals that touch [low, high], their end points included.
  int first = static_cast<int>(std::lower_bound(begin, end, low) - begin) - 1;
  int last = static_cast<int>(std::upper_bound(begin, end, high) - begin);
  first = std::min(std::max(first, 0), intervals);
  last = std::min(std::max(last, first), intervals);
  return before[last] == before[first];
}

//------------------------------------------------------------------------------
glm::vec4 TransferFunction::ValueAt(float scalar) const
{
  const auto above = std::upper_bound(this->Positions.begin(), this->Positions.end(), scalar);
  const int last = this->GetNumberOfNodes() - 2;
  const int interval =
    std::clamp(static_cast<int>(above - this->Positions.begin()) - 1, 0, last);
  const float below = this->Positions[interval];
  const float width = this->Positions[interval + 1] - below;
  const float weight = width > 0.0f ? std::clamp((scalar - below) / width, 0.0f, 1.0f) : 0.0f;
  const float* values = &this->Values[4 * static_cast<size_t>(interval)];
  return glm::mix(glm::make_vec4(values), glm::make_vec4(values + 4), weight);
}
