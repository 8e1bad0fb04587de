#ifndef ShellTargets_h
#define ShellTargets_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <array>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class ShellTargets
 * @brief One float per pixel and slice of a shell, four slices to a texture, blended to the
 * maximum.
 *
 * There are two sets, used in turn: the blending stage also sees the last slice of the shell
 * before.
 */
class ShellTargets
{
public:
  /// Makes both sets in this size. False where the driver cannot render to them.
  bool Prepare(vtkOpenGLRenderWindow* window, int width, int height, int samplesPerShell);

  /// Between these, what is drawn goes to the next set, cleared within the scissor box.
  void BeginShell(vtkOpenGLRenderWindow* window);
  void EndShell(vtkOpenGLRenderWindow* window);

  /// Binds the last set and, as `lastSlices`, the one before.
  void Activate(vtkShaderProgram* program);
  void Deactivate();

  void ReleaseGraphicsResources(vtkWindow* window);

  /// Of an element of the arrays when nothing was sampled; below every scalar and every end of the
  /// mesh (cpShell.glsl).
  static constexpr float Empty = -16777216.0f;

  int GetNumberOfTargets() const { return this->NumberOfTargets; }

private:
  struct Set
  {
    vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
    std::array<vtkNew<vtkTextureObject>, 4> Slices;
  };
  bool MakeSet(vtkOpenGLRenderWindow* window, Set& set, int width, int height);

  Set Sets[2];
  int Newest = 0;
  int NumberOfTargets = 0;
};

#endif
