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
 * The nodes reach far beyond 0 and 1, so every scalar lies in an interval.
 *
 * On the step itself the function has a value of its own, which a scalar that is one in a whole cell
 * can meet. VTK 9.1 takes the lower side of two nodes at one scalar, VTK 9.6 of the opacity the
 * upper, of the colour the lower one. With Steps::OfCells every step has its own value over
 * StepWidth to both sides: whatever rounding an engine adds, it is VTK's, and a scalar that a float
 * hardly tells from the step's counts as on it. With Steps::OfPoints the
 * step is moved by a float's last digit to the side that has its own opacity: a cell whose points
 * all have that scalar is drawn with one of the two sides, and VTK's is not guaranteed.
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

  /// What the scalars are, and so what happens on a step.
  enum class Steps
  {
    OfPoints,
    OfCells
  };
  /// Share of a position that counts as the position itself.
  static constexpr float StepWidth = 4e-6f;

  /// `candidates`: scalars where the function may bend or jump, in any order. `range`: what 0 and 1
  /// stand for; `extremes`: the least and the greatest scalar, beyond the range or its ends.
  void Build(std::vector<double> candidates, const Evaluator& evaluate, const double range[2],
    const double extremes[2], double unitDistance, Steps steps = Steps::OfPoints);

  /// True where the extinction is zero on the whole normalised interval.
  bool IsTransparent(float low, float high) const;

  /// True where colour times extinction is zero on the whole normalised interval.
  bool IsDark(float low, float high) const;

  /// Colour and extinction at a normalised scalar.
  glm::vec4 ValueAt(float scalar) const;

  const std::vector<float>& GetPositions() const { return this->Positions; }
  const std::vector<float>& GetValues() const { return this->Values; }
  int GetNumberOfNodes() const { return static_cast<int>(this->Positions.size()); }

private:
  struct Node
  {
    double Scalar;
    Sample Value;
    // Share of the position by which it lies beside its scalar.
    float Beside = 0.0f;
  };
  // The function at a scalar and in the limits from both sides.
  struct Joint
  {
    double Scalar;
    Sample Below, Here, Above;
  };

  void AppendJoint(const Joint& joint, Steps steps, const Evaluator& evaluate);
  void AppendStep(const Joint& joint, Steps steps);
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
