#ifndef DepthPixels_h
#define DepthPixels_h

#include <array>
#include <cstdint>
#include <vector>

/**
 * @class DepthPixels
 * @brief Window depths of a part of a viewport, in the numbers of the depth buffer.
 *
 * Integers from 0 to the largest of 32 bits, or floats from 0 to 1. Most scenes have nothing opaque:
 * then they are looked at once and never converted.
 */
class DepthPixels
{
public:
  /// x, y, width and height in pixels of the viewport.
  using Box = std::array<int, 4>;

  /// Where to put that part's depths, row by row, without gaps. The memory stays from frame to frame.
  void* Allocate(const Box& box, bool areFloats);

  /// Whether nothing opaque is there: all depths are 1, or there are none.
  bool AreClear() const;

  /// To the whole viewport of `width` x `height` pixels, row by row; 1 beside the part.
  void Expand(int width, int height, std::vector<float>& depths) const;

private:
  float ValueOf(std::uint32_t bits) const;

  Box Part{ { 0, 0, 0, 0 } };
  bool AreFloats = false;
  std::vector<std::uint32_t> Bits;
};

#endif
