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
      high > low ? (done - low) / (high - low) : 0.0,
      high > low ? (end - done) / (high - low) : 1.0 };
    if (falls)
    {
      std::swap(piece.Front, piece.Back);
      piece.Begin = 1.0 - piece.Begin - piece.Share;
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
void SegmentIntegral::Sum::Add(const Value& value, double share, double weight)
{
  const double ahead = 1.0 - share;
  for (int i = 0; i < 3; ++i)
  {
    this->Color[i] += weight * value[i];
    this->Front[i] += weight * ahead * value[i];
  }
  this->Ahead += weight * ahead;
  this->AheadSquared += weight * ahead * ahead;
}

//------------------------------------------------------------------------------
void SegmentIntegral::Sum::Divide(double total)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Color[i] /= total;
    this->Front[i] /= total;
  }
  this->Ahead /= total;
  this->AheadSquared /= total;
}

//------------------------------------------------------------------------------
void SegmentIntegral::AddStep(const Piece& piece, double from, double to, double length, Sum& sum)
{
  const Value front = Mix(piece.Front, piece.Back, from);
  const Value back = Mix(piece.Front, piece.Back, to);
  const double stepLength = (to - from) * length;
  const double depthFront = front[3] * stepLength;
  const double depthRise = (back[3] - front[3]) * stepLength;
  double absorbed[3], total = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double t = GaussNodes[i];
    absorbed[i] = GaussWeights[i] * (depthFront + depthRise * t) *
                  std::exp(-t * (depthFront + 0.5 * depthRise * t));
    total += absorbed[i];
  }
  const double alpha = -std::expm1(-(depthFront + 0.5 * depthRise));
  const double scale = total > 0.0 ? (1.0 - sum.Alpha) * alpha / total : 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double within = from + (to - from) * GaussNodes[i];
    const Value value = Mix(front, back, GaussNodes[i]);
    sum.Add(value, piece.Begin + within * piece.Share, scale * absorbed[i]);
  }
  sum.Alpha += (1.0 - sum.Alpha) * alpha;
}

//------------------------------------------------------------------------------
SegmentIntegral::Sum SegmentIntegral::FindThin() const
{
  Sum sum;
  for (const Piece& piece : this->Pieces)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Value value = Mix(piece.Front, piece.Back, GaussNodes[i]);
      // Where nothing is absorbed at all, what little would be counts alike everywhere.
      const double emitted = this->MeanExtinction > 0.0 ? value[3] : 1.0;
      sum.Add(value, piece.Begin + GaussNodes[i] * piece.Share,
        piece.Share * GaussWeights[i] * emitted);
    }
  }
  sum.Divide(this->MeanExtinction > 0.0 ? this->MeanExtinction : 1.0);
  return sum;
}

//------------------------------------------------------------------------------
SegmentIntegral::Means SegmentIntegral::FindMeans(double length) const
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
    return this->FindThin();
  }
  sum.Divide(sum.Alpha);
  return sum;
}
