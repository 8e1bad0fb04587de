#ifndef DepthLayers_h
#define DepthLayers_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <array>
#include <functional>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class DepthLayers
 * @brief Depths at which cells that no order satisfies are entered, per pixel, from back to front.
 *
 * The cells are disjoint, so along one ray their segments are ordered by their entries; this is
 * Everitt's depth peeling, "Interactive order-independent transparency", 2001, from the far side
 * and with the entry in a float target instead of a depth buffer. A search draws the cells' entries
 * that lie before the last layer's with MAX blending; what it found is the next layer. It takes as
 * many layers as cells lie behind one another at any pixel, and one more to find none.
 */
class DepthLayers
{
public:
  DepthLayers();
  ~DepthLayers();

  /// Makes targets of this size. False where the driver cannot render to them.
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height);
  void End();

  /// One program writes entries before `layerBehind`, the other draws what begins at `thisLayer`.
  struct Programs
  {
    vtkShaderProgram* Search = nullptr;
    vtkShaderProgram* Layer = nullptr;
  };
  using Drawer = std::function<void(vtkShaderProgram* program)>;

  /// Layer by layer, of no more than `cells` cells that `draw` draws with the program that is ready.
  /// Confined to `box`: x, y, width, height in pixels.
  void DrawGroup(
    const std::array<int, 4>& box, int cells, const Programs& programs, const Drawer& draw);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void BeginGroup(const std::array<int, 4>& box);
  /// Between these, what is drawn goes to the next layer instead of the framebuffer bound before.
  void BeginSearch(vtkShaderProgram* program);
  void EndSearch();
  /// Whether the last search found anything at any pixel; waits for it.
  bool WasAnyFound();
  /// The layer found last and the one behind it, to the program in use.
  void SetUniforms(vtkShaderProgram* program);
  struct Layer
  {
    vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
    vtkNew<vtkTextureObject> Depth;
  };
  bool MakeTarget(Layer& layer, int width, int height);
  void BindAndClear(Layer& layer, float depth);

  Layer Layers[2];
  vtkOpenGLRenderWindow* Window = nullptr;
  unsigned int Query = 0;
  int Newest = 0;
};

#endif
