#include "CoarseImage.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
// Window depth by which surfaces must differ before it counts.
constexpr float DepthStep = 1e-4f;

int CoarseSize(int size, double distance)
{
  return std::max(1, static_cast<int>(std::ceil(size / distance)));
}
}

//------------------------------------------------------------------------------
void CoarseImage::SetSize(int width, int height, double distance)
{
  const int size[2] = { width, height };
  for (int k = 0; k < 2; ++k)
  {
    this->Size[k] = size[k];
    this->Coarse[k] = CoarseSize(size[k], distance);
  }
  this->Columns = FindPlaces(this->Size[0], this->Coarse[0]);
  this->Rows = FindPlaces(this->Size[1], this->Coarse[1]);
  this->Depths.clear();
  this->CoarseDepths.clear();
}

//------------------------------------------------------------------------------
std::vector<CoarseImage::Place> CoarseImage::FindPlaces(int size, int coarse)
{
  std::vector<Place> places(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i)
  {
    const double at = (i + 0.5) * coarse / size - 0.5;
    const double inside = std::min(std::max(at, 0.0), coarse - 1.0);
    const int first = static_cast<int>(inside);
    places[i] = { first, std::min(first + 1, coarse - 1), static_cast<float>(inside - first) };
  }
  return places;
}

//------------------------------------------------------------------------------
const std::vector<float>& CoarseImage::ReduceDepths(std::vector<float>& depths)
{
  this->Depths.swap(depths);
  if (this->Depths.empty())
  {
    return this->CoarseDepths;
  }
  this->CoarseDepths.resize(static_cast<std::size_t>(this->Coarse[0]) * this->Coarse[1]);
  float* out = this->CoarseDepths.data();
  for (int y = 0; y < this->Coarse[1]; ++y)
  {
    const auto row = static_cast<int>((y + 0.5) * this->Size[1] / this->Coarse[1]);
    for (int x = 0; x < this->Coarse[0]; ++x)
    {
      const auto column = static_cast<int>((x + 0.5) * this->Size[0] / this->Coarse[0]);
      *out++ = this->Depths[static_cast<std::size_t>(row) * this->Size[0] + column];
    }
  }
  return this->CoarseDepths;
}

//------------------------------------------------------------------------------
std::array<float, 4> CoarseImage::Weigh(const Place& x, const Place& y, const float* depth) const
{
  std::array<float, 4> weights = { { (1.0f - x.Share) * (1.0f - y.Share),
    x.Share * (1.0f - y.Share), (1.0f - x.Share) * y.Share, x.Share * y.Share } };
  if (!depth)
  {
    return weights;
  }
  const int places[4][2] = { { x.First, y.First }, { x.Second, y.First }, { x.First, y.Second },
    { x.Second, y.Second } };
  float sum = 0.0f;
  for (int i = 0; i < 4; ++i)
  {
    const float other =
      this->CoarseDepths[static_cast<std::size_t>(places[i][1]) * this->Coarse[0] + places[i][0]];
    // No place is without weight: the only surface that is the pixel's own may be the farthest.
    weights[i] = (weights[i] + 1e-3f) * DepthStep / (DepthStep + std::abs(other - *depth));
    sum += weights[i];
  }
  for (float& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

//------------------------------------------------------------------------------
void CoarseImage::EnlargeRow(const float* image, int y)
{
  const Place& row = this->Rows[y];
  const std::size_t begin = static_cast<std::size_t>(y) * this->Size[0];
  const float* first = image + 4 * static_cast<std::size_t>(row.First) * this->Coarse[0];
  const float* second = image + 4 * static_cast<std::size_t>(row.Second) * this->Coarse[0];
  for (int x = 0; x < this->Size[0]; ++x)
  {
    const Place& column = this->Columns[x];
    const float* depth = this->Depths.empty() ? nullptr : &this->Depths[begin + x];
    const std::array<float, 4> weights = this->Weigh(column, row, depth);
    float* out = &this->Image[4 * (begin + x)];
    for (int k = 0; k < 4; ++k)
    {
      out[k] = weights[0] * first[4 * column.First + k] + weights[1] * first[4 * column.Second + k] +
               weights[2] * second[4 * column.First + k] +
               weights[3] * second[4 * column.Second + k];
    }
  }
}

//------------------------------------------------------------------------------
const float* CoarseImage::Enlarge(const float* image)
{
  this->Image.resize(4 * static_cast<std::size_t>(this->Size[0]) * this->Size[1]);
  vtkSMPTools::For(0, this->Size[1],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType y = begin; y < end; ++y)
      {
        this->EnlargeRow(image, static_cast<int>(y));
      }
    });
  return this->Image.data();
}
