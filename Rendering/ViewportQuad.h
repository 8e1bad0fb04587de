#ifndef ViewportQuad_h
#define ViewportQuad_h

#include <memory>
#include <string>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * @class ViewportQuad
 * @brief A fragment program that is drawn over the whole viewport.
 */
class ViewportQuad
{
public:
  ViewportQuad();
  ~ViewportQuad();

  /// The program of this source, ready; null where it does not compile.
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const std::string& fragment);
  void Draw();
  void ReleaseGraphicsResources();

private:
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::string Source;
};

#endif
