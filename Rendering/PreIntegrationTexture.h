#ifndef PreIntegrationTexture_h
#define PreIntegrationTexture_h

#include "vtkNew.h"
#include "vtkTextureObject.h"

class PreIntegrationTable;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class PreIntegrationTexture
 * @brief A pre-integration table on the GPU, read with linear interpolation.
 */
class PreIntegrationTexture
{
public:
  /// False where the driver has no room for it. The context must be current.
  bool Upload(vtkOpenGLRenderWindow* window, const PreIntegrationTable& table);
  /// Binds it, and sets the uniforms of cpTableSegment.glsl.
  void Activate(vtkShaderProgram* program);
  void Deactivate() { this->Texture->Deactivate(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Texture;
  float Range[2] = { 0.0f, 1.0f };
  float GreatestExtinction = 0.0f;
  float GreatestLength = 1.0f;
};

#endif
