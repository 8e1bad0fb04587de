#ifndef ExtremumTarget_h
#define ExtremumTarget_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <memory>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class ExtremumTarget
 * @brief One float per pixel that keeps the greatest, or least, value drawn to it.
 */
class ExtremumTarget
{
public:
  ExtremumTarget();
  ~ExtremumTarget();

  /// Draws go here until End. False where the driver cannot render to single floats.
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height, bool findLeast);
  void End(vtkOpenGLRenderWindow* window);

  /// Between Begin and End: whether `opaqueDepth` has a pixel with opaque geometry.
  bool HasOpaque(vtkOpenGLRenderWindow* window, vtkTextureObject* opaqueDepth);

  /// The program that turns the values into colours over the whole viewport, ready; null where it
  /// does not compile. Then Draw.
  vtkShaderProgram* ReadyColourProgram(vtkOpenGLRenderWindow* window);
  void DrawColours(vtkShaderProgram* program);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  using Quad = std::unique_ptr<vtkOpenGLQuadHelper>;
  static vtkShaderProgram* ReadyQuad(
    vtkOpenGLRenderWindow* window, Quad& quad, const char* fragment);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Values;
  Quad ColourQuad;
  Quad QueryQuad;
  unsigned int Query = 0;
  float Nothing = 0.0f;
};

#endif
