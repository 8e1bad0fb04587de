#ifndef ElementProjection_h
#define ElementProjection_h

#include "ElementVertices.h"
#include "RasterView.h"

#include <string>
#include <vector>

class ElementBuffers;
class vtkOpenGLRenderWindow;

/**
 * @class ElementProjection
 * @brief Raster engine of cell projection by the barycentric stages: each element from its entry to
 * its exit, from back to front.
 *
 * Paper: Georgii and Westermann 2006, section 5.
 */
class ElementProjection
{
public:
  /// Draws into the bound framebuffer, which lays what comes over what is there. `vertices`, as
  /// ElementLists gives them, from back to front. False, with the reason in GetFailure, where it
  /// cannot.
  bool Draw(vtkOpenGLRenderWindow* window, const RasterView& view,
    const std::vector<int>& vertices, ElementBuffers& buffers);

  void ReleaseGraphicsResources() { this->Vertices.ReleaseGraphicsResources(); }
  const std::string& GetFailure() const { return this->Failure; }

private:
  ElementVertices Vertices;
  std::string Failure;
};

#endif
