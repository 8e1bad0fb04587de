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

  /// Reads the colours of that part of a viewport at `origin`. False where the framebuffer is not one
  /// texture of linear RGBA in bytes with one sample per pixel, or where a mask, a stencil or a logic operation
  /// would have a say in what is drawn.
  bool Read(vtkOpenGLRenderWindow* window, const int origin[2], const Box& box);

  /// Lays the part that was read of an image, premultiplied RGBA of a viewport that is `width` pixels
  /// wide, over those colours and puts them back. Nothing else must have drawn there. False, with nothing done,
  /// where nothing was read since.
  bool LayOver(const float* image, int width);

private:
  void ReadColors();
  void Blend(const float* image, int width);

  std::vector<unsigned char> Colors;
  /// What was read: the texture, 0 for none, where it begins there, and the part of the image.
  unsigned int Texture = 0;
  std::array<int, 2> Corner{};
  Box Part{};
};

#endif
