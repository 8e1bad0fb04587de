#ifndef TextureBuffer_h
#define TextureBuffer_h

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkTextureObject.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class TextureBuffer
 * @brief An array on the GPU that shaders read by index (texelFetch on a buffer sampler).
 */
class TextureBuffer
{
public:
  /// Uploads `count` values, `components` (1 or 4) per texel. False, with the reason in GetFailure,
  /// where the array exceeds what the driver's texture buffers hold. The context must be current.
  bool Upload(vtkOpenGLRenderWindow* window, const float* values, size_t count, int components);
  bool Upload(vtkOpenGLRenderWindow* window, const int* values, size_t count, int components);
  template <class Value>
  bool Upload(vtkOpenGLRenderWindow* window, const std::vector<Value>& values, int components)
  {
    return this->Upload(window, values.data(), values.size(), components);
  }

  /// Binds the array to a texture unit of its own and tells the sampler `name` which.
  void Activate(vtkShaderProgram* program, const char* name);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetFailure() const { return this->Failure; }

private:
  bool Fits(size_t texels);
  bool Create(vtkOpenGLRenderWindow* window, size_t texels, int components, int type, int format);

  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  std::string Failure;
};

#endif
