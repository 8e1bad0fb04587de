#include "DepthPixels.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace
{
// The bits of 1 in either kind of number.
constexpr std::uint32_t LargestInteger = 0xffffffffu;
constexpr std::uint32_t FloatOne = 0x3f800000u;
// As many as are compared before it is asked whether one of them was less.
constexpr std::size_t Block = 4096;
}

//------------------------------------------------------------------------------
void* DepthPixels::Allocate(const Box& box, bool areFloats)
{
  this->Part = box;
  this->AreFloats = areFloats;
  this->Bits.resize(static_cast<std::size_t>(box[2]) * box[3]);
  return this->Bits.data();
}

//------------------------------------------------------------------------------
bool DepthPixels::AreClear() const
{
  // The bits of floats from 0 on are in the floats' order.
  const std::uint32_t one = this->AreFloats ? FloatOne : LargestInteger;
  for (std::size_t begin = 0; begin < this->Bits.size(); begin += Block)
  {
    const std::size_t end = std::min(begin + Block, this->Bits.size());
    std::uint32_t isLess = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      isLess |= this->Bits[i] < one ? 1u : 0u;
    }
    if (isLess != 0)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
float DepthPixels::ValueOf(std::uint32_t bits) const
{
  if (!this->AreFloats)
  {
    return static_cast<float>(bits / static_cast<double>(LargestInteger));
  }
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

//------------------------------------------------------------------------------
void DepthPixels::Expand(int width, int height, std::vector<float>& depths) const
{
  depths.resize(static_cast<std::size_t>(width) * height);
  vtkSMPTools::For(0, height, 32,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType y = begin; y < end; ++y)
      {
        float* row = &depths[static_cast<std::size_t>(y) * width];
        std::fill_n(row, width, 1.0f);
        if (y >= this->Part[1] && y < this->Part[1] + this->Part[3])
        {
          const std::uint32_t* own =
            this->Bits.data() + static_cast<std::size_t>(y - this->Part[1]) * this->Part[2];
          std::transform(own, own + this->Part[2], row + this->Part[0],
            [this](std::uint32_t bits) { return this->ValueOf(bits); });
        }
      }
    });
}
