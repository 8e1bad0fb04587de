#ifndef ScreenBox_h
#define ScreenBox_h

#include <glm/mat4x4.hpp>

#include <array>
#include <vector>

/// Where cells lie on the screen.
namespace ScreenBox
{
struct View
{
  glm::mat4 MeshToClip{ 1.0f };
  int Width = 0;
  int Height = 0;
};

/// x, y, width and height in pixels of the viewport: all of it where a corner lies behind the near
/// plane. `points`: 4 floats each, mesh coordinates; `corners`: 4 point ids per cell; `cells`:
/// `count` indices of cells.
std::array<int, 4> Around(const std::vector<float>& points, const std::vector<int>& corners,
  const unsigned int* cells, int count, const View& view);
}

#endif
