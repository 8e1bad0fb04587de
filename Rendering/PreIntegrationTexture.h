#ifndef PreIntegrationTexture_h
#define PreIntegrationTexture_h

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <vector>

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
  /// Binds it, and sets the uniforms of cpTableLookUp.glsl and cpLitTable.glsl.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Upload(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
    const std::vector<float>& texels, int size);

  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkTextureObject> Front;
  vtkNew<vtkTextureObject> Back;
  bool IsLit = false;
  float Range[2] = { 0.0f, 1.0f };
  float GreatestExtinction = 0.0f;
  float GreatestLength = 1.0f;
};

#endif
