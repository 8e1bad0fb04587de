#include "ScreenBox.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

//------------------------------------------------------------------------------
std::array<int, 4> ScreenBox::Around(const std::vector<float>& points,
  const std::vector<int>& corners, const unsigned int* cells, int count, const View& view)
{
  const glm::vec2 size(view.Width, view.Height);
  glm::vec2 low = size;
  glm::vec2 high(0.0f);
  for (int i = 0; i < 4 * count; ++i)
  {
    const size_t id = corners[4 * static_cast<size_t>(cells[i / 4]) + i % 4];
    const float* p = &points[4 * id];
    const glm::vec4 clip = view.MeshToClip * glm::vec4(p[0], p[1], p[2], 1.0f);
    if (!(clip.z >= -clip.w && clip.w > 0.0f))
    {
      return { { 0, 0, view.Width, view.Height } };
    }
    const glm::vec2 pixel = (glm::vec2(clip) / clip.w * 0.5f + 0.5f) * size;
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
  }
  // A pixel more: footprints are a little larger than the cells.
  low = glm::clamp(glm::floor(low) - 1.0f, glm::vec2(0.0f), size);
  high = glm::clamp(glm::ceil(high) + 1.0f, low, size);
  return { { static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(high.x - low.x),
    static_cast<int>(high.y - low.y) } };
}
