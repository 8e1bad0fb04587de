#ifndef FloatTarget_h
#define FloatTarget_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <array>
#include <memory>

class vtkImageData;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkWindow;

/**
 * @class FloatTarget
 * @brief The volume's own image: premultiplied RGBA in 32-bit floats, the size of the viewport.
 *
 * Eight bits would cost 2e-2, half floats 2.5e-3 of accuracy.
 */
class FloatTarget
{
public:
  FloatTarget();
  ~FloatTarget();

  /// Binds a cleared target of this size, draws go there until End. False where the driver cannot
  /// render to it. Blending is set up for premultiplied cells from back to front.
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height);
  void End(vtkOpenGLRenderWindow* window);

  /// What is drawn to.
  vtkTextureObject* GetTexture() { return this->Color; }
  /// A part of the image: x, y, width and height.
  using Box = std::array<int, 4>;

  /// Takes that part of an image that was drawn elsewhere instead.
  void Upload(
    vtkOpenGLRenderWindow* window, const int size[2], const Box& box, const float* image);

  /// The image as one float array RGBA, first row at the bottom.
  void Capture(vtkImageData* image);

  /// Lays that part of the image over what the window's framebuffer holds at `origin`.
  void Blend(
    vtkOpenGLRenderWindow* window, const int origin[2], const int size[2], const Box& box);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Allocate(vtkOpenGLRenderWindow* window, int width, int height);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Color;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

#endif
