#ifndef WindowPixels_h
#define WindowPixels_h

#include <array>
#include <vector>

class vtkOpenGLRenderWindow;

/**
 * @class WindowPixels
 * @brief Lays an image in memory over the framebuffer that is bound for drawing, without drawing.
 *
 * Where OpenGL is software, its framebuffer is memory too: reading the colours, blending them here
 * and putting them back takes a fifth of the time of a textured rectangle. Nothing of the image goes
 * to a texture.
 */
class WindowPixels
{
public:
  /// A part of the image: x, y, width and height.
  using Box = std::array<int, 4>;

  /// Lays that part of the image, premultiplied RGBA of a viewport at `origin` that is `width` pixels
  /// wide, over the framebuffer. False, with nothing done, where that is not one texture of linear
  /// RGBA in bytes with one sample per pixel, or where a mask, a stencil or a logic operation would
  /// have a say in what is drawn.
  bool LayOver(vtkOpenGLRenderWindow* window, const int origin[2], const Box& box,
    const float* image, int width);

private:
  bool Exchange(const int corner[2], const Box& box, const float* image, int width);
  void Blend(const Box& box, const float* image, int width);

  std::vector<unsigned char> Colors;
};

#endif
