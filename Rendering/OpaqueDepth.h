#ifndef OpaqueDepth_h
#define OpaqueDepth_h

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

/**
 * @class OpaqueDepth
 * @brief The depth of the opaque scene in one viewport, as a texture of window depths.
 *
 * Reads the framebuffer that is bound for drawing, whatever made it. Multisampled depth is resolved
 * first (the driver picks one sample: on the edge of a surface a pixel is either inside or
 * outside).
 */
class OpaqueDepth
{
public:
  /// False where the framebuffer has no depth or cannot be read; the scene counts as empty then.
  bool Grab(vtkOpenGLRenderWindow* window, const int origin[2], const int size[2]);
  vtkTextureObject* GetTexture() { return this->Depth; }
  /// What was grabbed, row by row; empty where all of it is 1.
  void Read(std::vector<float>& depths);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Copy(vtkOpenGLRenderWindow* window, const int origin[2], const int size[2]);
  void Allocate(vtkOpenGLRenderWindow* window, const int size[2]);
  bool Resolve(vtkOpenGLRenderWindow* window, const int origin[2], const int size[2]);
  void CopyBound(const int origin[2], const int size[2]);

  vtkNew<vtkTextureObject> Depth;
};

#endif
