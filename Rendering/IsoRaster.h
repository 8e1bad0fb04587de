#ifndef IsoRaster_h
#define IsoRaster_h

#include "ElementVertices.h"
#include "IsoLayers.h"
#include "RasterView.h"
#include "ViewportQuad.h"

#include <array>
#include <string>
#include <vector>

class ElementBuffers;
class ShadingBuffers;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * @class IsoRaster
 * @brief Raster engine of iso-surfaces: where each ray meets them inside the elements, exactly,
 * lit, nearest first.
 *
 * Paper: Georgii and Westermann 2006, section 4. Opaque surfaces take one pass over the elements
 * that they cut, in any order; translucent ones one more for each layer, peeled from front to back.
 */
class IsoRaster
{
public:
  /// More are not drawn.
  static constexpr int MaximumValues = 16;

  struct View : RasterView
  {
    /// The elements that are cut, as ElementLists gives them.
    const std::vector<int>* Vertices = nullptr;
    /// Normalised.
    std::vector<float> Values;
    bool IsOpaque = false;
    /// The least depth of the mesh from the reference plane, and how deep it is.
    std::array<float, 2> Depths{ { 0.0f, 1.0f } };
  };

  /// Draws into the bound framebuffer. False, with the reason in GetFailure, where it cannot.
  bool Draw(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers,
    ShadingBuffers& shading);

  /// Writes the depth of the nearest surface, where it is opaque, to the framebuffer that is bound,
  /// at `origin`.
  void DrawDepth(vtkOpenGLRenderWindow* window, const View& view, const int origin[2]);

  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetFailure() const { return this->Failure; }

private:
  bool Prepare(vtkOpenGLRenderWindow* window, const View& view, bool isLit);
  bool DrawLayer(vtkOpenGLRenderWindow* window, const View& view, int layer);
  void BlendLayer(vtkOpenGLRenderWindow* window);

  ElementVertices Vertices;
  IsoLayers Layers;
  ViewportQuad Blend;
  ViewportQuad Depth;
  vtkShaderProgram* Surfaces = nullptr;
  std::string Failure;
};

#endif
