#ifndef TransferFunction_h
#define TransferFunction_h

#include <glm/vec4.hpp>

#include <array>
#include <functional>
#include <vector>

/**
 * @class TransferFunction
 * @brief Colour and extinction as one piecewise-linear function of the normalised scalar.
 *
 * Scalars are normalised to [0,1] over the range given to Build. Positions holds one ascending
 * value per node, Values four per node: red, green, blue, extinction per world length. Two nodes at
 * one position are a step: the first holds the limit from below, the second the limit from above.
 * The first node is at 0, the last at 1, so every scalar of the range lies in an interval.
 *
 * Functions that are linear between the candidate positions are represented exactly, others (HSV,
 * Lab, Diverging, logarithmic scale, midpoint and sharpness) by bisection until three samples of an
 * interval lie within Tolerance of its chord. Features narrower than a quarter of an interval
 * between candidates are not guaranteed to be found.
 */
class TransferFunction
{
public:
  /// Red, green, blue, opacity per unit distance at a scalar.
  using Sample = std::array<double, 4>;
  using Evaluator = std::function<Sample(double)>;

  /// Largest difference to the function that is represented, in colour and opacity.
  static constexpr double Tolerance = 1e-4;

  /// `candidates`: scalars where the function may bend or jump, in any order. `range`: what 0 and 1
  /// stand for; `extremes`: the least and the greatest scalar, beyond the range or its ends.
  void Build(std::vector<double> candidates, const Evaluator& evaluate, const double range[2],
    const double extremes[2], double unitDistance);

  /// True where the extinction is zero on the whole normalised interval.
  bool IsTransparent(float low, float high) const;

  /// True where colour times extinction is zero on the whole normalised interval.
  bool IsDark(float low, float high) const;

  /// Colour and extinction at a normalised scalar; on a step the limit from above.
  glm::vec4 ValueAt(float scalar) const;

  const std::vector<float>& GetPositions() const { return this->Positions; }
  const std::vector<float>& GetValues() const { return this->Values; }
  int GetNumberOfNodes() const { return static_cast<int>(this->Positions.size()); }

private:
  struct Node
  {
    double Scalar;
    Sample Value;
  };

  void AppendJoint(double scalar, double step, bool first, bool last, const Evaluator& evaluate);
  void Refine(const Node& low, const Node& high, int depth, const Evaluator& evaluate);
  void Store(double unitDistance);
  void CountVisible();
  bool IsNothing(const std::vector<int>& before, float low, float high) const;

  // The range that positions count from.
  double Low = 0.0;
  double Width = 0.0;
  std::vector<Node> Nodes;
  std::vector<float> Positions;
  std::vector<float> Values;
  // VisibleBefore[i]: how many of the intervals before interval i have any extinction.
  std::vector<int> VisibleBefore;
  // The same of intervals with any emission.
  std::vector<int> EmittingBefore;
};

#endif
