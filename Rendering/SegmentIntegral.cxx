#include "SegmentIntegral.h"

#include "TransferFunction.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double GaussNodes[3] = { 0.11270166537925831, 0.5, 0.88729833462074169 };
constexpr double GaussWeights[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
// Of a step of the quadrature.
constexpr double MaximumOpticalDepth = 1.0;
// Behind this much of it nothing is seen.
constexpr double OpaqueDepth = 40.0;

using Value = std::array<double, 4>;

Value Mix(const Value& a, const Value& b, double weight)
{
  Value mixed;
  for (int i = 0; i < 4; ++i)
  {
    mixed[i] = a[i] + weight * (b[i] - a[i]);
  }
  return mixed;
}

Value ValueIn(const TransferFunction& function, int interval, double scalar)
{
  const std::vector<float>& positions = function.GetPositions();
  const float* values = &function.GetValues()[4 * static_cast<size_t>(interval)];
  const double below = positions[interval];
  const double width = positions[interval + 1] - below;
  const double weight = width > 0.0 ? std::clamp((scalar - below) / width, 0.0, 1.0) : 0.0;
  return Mix({ { values[0], values[1], values[2], values[3] } },
    { { values[4], values[5], values[6], values[7] } }, weight);
}
}

//------------------------------------------------------------------------------
SegmentIntegral::SegmentIntegral(const TransferFunction& function, double front, double back)
{
  const std::vector<float>& positions = function.GetPositions();
  const bool falls = back < front;
  const double low = std::min(front, back), high = std::max(front, back);
  const auto above = std::upper_bound(positions.begin(), positions.end(), low);
  int interval =
    std::clamp(static_cast<int>(above - positions.begin()) - 1, 0, function.GetNumberOfNodes() - 2);
  double done = low;
  for (bool last = false; !last; ++interval)
  {
    last = interval + 2 >= function.GetNumberOfNodes() || positions[interval + 1] >= high;
    const double end = last ? high : static_cast<double>(positions[interval + 1]);
    Piece piece{ ValueIn(function, interval, done), ValueIn(function, interval, end),
      high > low ? (end - done) / (high - low) : 1.0 };
    if (falls)
    {
      std::swap(piece.Front, piece.Back);
    }
    this->MeanExtinction += 0.5 * piece.Share * (piece.Front[3] + piece.Back[3]);
    this->Pieces.push_back(piece);
    done = end;
  }
  if (falls)
  {
    std::reverse(this->Pieces.begin(), this->Pieces.end());
  }
}

//------------------------------------------------------------------------------
void SegmentIntegral::AddStep(const Piece& piece, double from, double to, double length, Sum& sum)
{
  const Value front = Mix(piece.Front, piece.Back, from);
  const Value back = Mix(piece.Front, piece.Back, to);
  const double stepLength = (to - from) * length;
  const double depthFront = front[3] * stepLength;
  const double depthRise = (back[3] - front[3]) * stepLength;
  const double alpha = -std::expm1(-(depthFront + 0.5 * depthRise));
  double mean = 0.0, total = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double t = GaussNodes[i];
    const double absorbed = GaussWeights[i] * (depthFront + depthRise * t) *
                            std::exp(-t * (depthFront + 0.5 * depthRise * t));
    mean += absorbed * t;
    total += absorbed;
  }
  const Value value = Mix(front, back, total > 0.0 ? mean / total : 0.5);
  for (int i = 0; i < 3; ++i)
  {
    sum.Color[i] += (1.0 - sum.Alpha) * alpha * value[i];
  }
  sum.Alpha += (1.0 - sum.Alpha) * alpha;
}

//------------------------------------------------------------------------------
std::array<double, 3> SegmentIntegral::FindThinColor() const
{
  std::array<double, 3> emitted{ { 0.0, 0.0, 0.0 } }, mean = emitted;
  for (const Piece& piece : this->Pieces)
  {
    const Value middle = Mix(piece.Front, piece.Back, 0.5);
    for (int i = 0; i < 3; ++i)
    {
      emitted[i] += piece.Share / 6.0 *
                    (piece.Front[3] * piece.Front[i] + 4.0 * middle[3] * middle[i] +
                      piece.Back[3] * piece.Back[i]);
      mean[i] += piece.Share * middle[i];
    }
  }
  for (double& channel : emitted)
  {
    channel /= this->MeanExtinction;
  }
  return this->MeanExtinction > 0.0 ? emitted : mean;
}

//------------------------------------------------------------------------------
std::array<double, 3> SegmentIntegral::FindColor(double length) const
{
  Sum sum;
  double depth = 0.0;
  for (const Piece& piece : this->Pieces)
  {
    const double pieceDepth =
      std::max(piece.Front[3], piece.Back[3]) * piece.Share * length / MaximumOpticalDepth;
    const int steps = static_cast<int>(std::ceil(std::clamp(pieceDepth, 1.0, 64.0)));
    for (int i = 0; i < steps && depth < OpaqueDepth; ++i)
    {
      AddStep(piece, static_cast<double>(i) / steps, static_cast<double>(i + 1) / steps,
        piece.Share * length, sum);
    }
    depth += 0.5 * (piece.Front[3] + piece.Back[3]) * piece.Share * length;
  }
  // So thin that alpha keeps no digits: absorption plays no role.
  if (!(sum.Alpha > 1e-12))
  {
    return this->FindThinColor();
  }
  return { { sum.Color[0] / sum.Alpha, sum.Color[1] / sum.Alpha, sum.Color[2] / sum.Alpha } };
}
