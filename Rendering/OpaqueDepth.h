#ifndef OpaqueDepth_h
#define OpaqueDepth_h

#include "DepthPixels.h"
#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <array>
#include <functional>

class vtkOpenGLRenderWindow;
class vtkWindow;

/**
 * @class OpaqueDepth
 * @brief The depth of the opaque scene in one viewport, as a texture or as numbers.
 *
 * Reads the framebuffer that is bound for drawing, whatever made it. Multisampled depth is resolved
 * first (the driver picks one sample: on the edge of a surface a pixel is either inside or
 * outside).
 */
class OpaqueDepth
{
public:
  /// A part of the viewport: x, y, width and height.
  using Box = std::array<int, 4>;

  /// Window depths as a texture of the viewport's size. False where the framebuffer has no depth or
  /// cannot be read; the scene counts as empty then.
  bool Grab(vtkOpenGLRenderWindow* window, const int origin[2], const int size[2]);
  vtkTextureObject* GetTexture() { return this->Depth; }

  /// The same as numbers, of a part alone: no texture is made, and nothing converted where nothing
  /// opaque is there. False as Grab.
  bool Read(vtkOpenGLRenderWindow* window, const int origin[2], const Box& box);
  const DepthPixels& GetPixels() const { return this->Pixels; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// What a framebuffer of one sample per pixel, bound for reading, is read by; where the part begins.
  using Reading = std::function<void(const int corner[2])>;

  static bool Visit(vtkOpenGLRenderWindow* window, const int origin[2], const int size[2],
    const Reading& read);
  static bool VisitResolved(vtkOpenGLRenderWindow* window, const int origin[2], const int size[2],
    const Reading& read);
  void Allocate(vtkOpenGLRenderWindow* window, const int size[2]);
  void CopyBound(const int origin[2], const int size[2]);

  vtkNew<vtkTextureObject> Depth;
  DepthPixels Pixels;
};

#endif
