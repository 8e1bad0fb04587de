#ifndef ElementProjection_h
#define ElementProjection_h

#include "DepthLayers.h"
#include "DrawnCells.h"
#include "ElementVertices.h"
#include "RasterView.h"

#include <string>
#include <vector>

class ElementBuffers;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class ElementProjection
 * @brief Raster engine of cell projection by the barycentric stages: each element from its entry to
 * its exit, from back to front.
 *
 * Paper: Georgii and Westermann 2006, section 5. Elements that hide each other in a circle are put
 * in order per pixel (class DepthLayers).
 */
class ElementProjection
{
public:
  struct View : RasterView
  {
    /// From back to front, in runs.
    const DrawnCells* Cells = nullptr;
    /// Of these cells, as ElementLists gives them.
    const std::vector<int>* Vertices = nullptr;
    /// Of all cells, for the box of a run on the screen: 4 floats per point, 4 ids per cell.
    const std::vector<float>* Points = nullptr;
    const std::vector<int>* Corners = nullptr;
  };

  /// Draws into the bound framebuffer, which lays what comes over what is there. False, with the
  /// reason in GetFailure, where it cannot.
  bool Draw(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers);

  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetFailure() const { return this->Failure; }

private:
  /// What draws: all elements as they come, or of cyclic groups the next layer and its colour.
  struct Programs
  {
    vtkShaderProgram* Cells = nullptr;
    vtkShaderProgram* Search = nullptr;
    vtkShaderProgram* Layer = nullptr;
  };
  bool Prepare(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers);
  void Activate(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers);
  void DrawRuns(vtkOpenGLRenderWindow* window, const View& view);
  void DrawGroup(const View& view, const DrawnCells::Run& run);

  ElementVertices Vertices;
  DepthLayers Layers;
  bool HasLayers = false;
  Programs Ready;
  std::string Failure;
};

#endif
