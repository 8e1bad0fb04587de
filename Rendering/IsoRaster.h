#ifndef IsoRaster_h
#define IsoRaster_h

#include "ElementVertices.h"
#include "IsoLayers.h"
#include "IsoTriangleRaster.h"
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
 * Paper: Georgii and Westermann 2006, section 4. Opaque surfaces take one pass over their
 * triangles, in any order; translucent ones one over the elements that they cut for each layer,
 * peeled from front to back.
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
    /// In the place of the elements, where all surfaces are opaque.
    const IsoTriangleRaster::Source* Triangles = nullptr;
    /// The least depth of the mesh from the reference plane, and how deep it is.
    std::array<float, 2> Depths{ { 0.0f, 1.0f } };
  };

  /// Draws into the bound float target. False, with the reason in GetFailure, where it cannot.
  bool Draw(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers,
    ShadingBuffers& shading);

  /// The triangles straight into the window's framebuffer, which is bound, against its depth and
  /// into it; the viewport is at `origin`.
  bool DrawIntoWindow(vtkOpenGLRenderWindow* window, const View& view, const int origin[2],
    ShadingBuffers& shading);

  /// Writes the depth of the nearest surface, where it is opaque, to the framebuffer that is bound,
  /// at `origin`.
  void DrawDepth(vtkOpenGLRenderWindow* window, const View& view, const int origin[2]);

  void ReleaseGraphicsResources(vtkWindow* window);
  const IsoTriangleRaster& GetTriangles() const { return this->Triangles; }
  const std::string& GetFailure() const { return this->Failure; }

private:
  bool Prepare(vtkOpenGLRenderWindow* window, const View& view, const ShadingBuffers& shading);
  void DrawTriangles(vtkOpenGLRenderWindow* window, const View& view, ShadingBuffers& shading);
  void DrawElements(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers,
    ShadingBuffers& shading);
  bool DrawLayer(vtkOpenGLRenderWindow* window, const View& view, int layer);
  void BlendLayer(vtkOpenGLRenderWindow* window);

  ElementVertices Vertices;
  IsoTriangleRaster Triangles;
  IsoLayers Layers;
  ViewportQuad Blend;
  ViewportQuad Depth;
  vtkShaderProgram* Surfaces = nullptr;
  std::string Failure;
};

#endif
