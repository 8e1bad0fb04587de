#ifndef ShellRaster_h
#define ShellRaster_h

#include "ElementLists.h"
#include "ElementVertices.h"
#include "RasterView.h"
#include "ShellShaders.h"
#include "ShellTargets.h"
#include "ViewportQuad.h"

#include <array>
#include <string>
#include <vector>

class ElementBuffers;
struct MeshBlock;
struct PreparedVolume;
class ShellCells;
class ShellPlan;

/**
 * @class ShellRaster
 * @brief Raster engine of shells: from front to back, the elements of each are sampled on its
 * slices, in any order, then the slices are composited.
 *
 * Paper: Georgii and Westermann, "A generic and scalable pipeline for GPU tetrahedral grid
 * rendering", 2006. Stages: element assembly and primitive construction in the geometry shader, the
 * fragment stage in as many targets as a shell has slices / 4, the blending stage over the whole
 * box of the mesh on the screen. Pixels that are opaque take no more samples; when all are, no
 * shell follows.
 */
class ShellRaster
{
public:
  struct View : RasterView
  {
    vtkTextureObject* Image = nullptr;
    const ShellPlan* Plan = nullptr;
    const ShellCells* Cells = nullptr;
    /// 4 ids per cell.
    const std::vector<int>* Corners = nullptr;
    /// Empty where the whole mesh is uploaded; else these are, one after the other.
    const std::vector<MeshBlock>* Blocks = nullptr;
    const PreparedVolume* Prepared = nullptr;
    bool IsPreIntegrated = false;
    bool IsTextured = false;
    /// Where the mesh is on the screen: x, y, width and height in pixels of the viewport.
    std::array<int, 4> Box{ { 0, 0, 0, 0 } };
  };

  /// False where the driver cannot blend so many floats per pixel.
  bool CanDraw(vtkOpenGLRenderWindow* window, const int size[2], int samplesPerShell)
  {
    return this->Targets.Prepare(window, size[0], size[1], samplesPerShell);
  }

  /// Draws into the bound framebuffer, whose colours are `Image`. False, with the reason in
  /// GetFailure, where it cannot.
  bool Draw(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers);

  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetFailure() const { return this->Failure; }

  /// How many elements the last frame drew, each as often as the shells it overlaps.
  vtkIdType GetNumberOfElements() const { return this->NumberOfElements; }
  /// Until the last pixel was opaque.
  int GetNumberOfShells() const { return this->NumberOfShells; }

private:
  bool Prepare(vtkOpenGLRenderWindow* window, const View& view);
  void BeginLists(const View& view);
  int AdvanceLists();
  bool DrawShells(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers);
  bool SampleShell(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers,
    int shell, bool asks);
  bool DrawLists(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers);
  void BlendShell(vtkOpenGLRenderWindow* window, const View& view, int shell);
  /// Whether no pixel of the box can show what is behind, in two steps.
  void CountOpen(vtkOpenGLRenderWindow* window, const View& view);
  bool IsOpaque() const;
  void SetShell(vtkShaderProgram* program, const View& view, int shell);

  /// One per block.
  std::vector<ElementLists> Lists;
  ElementVertices Vertices;
  ShellTargets Targets;
  ViewportQuad Blend;
  ViewportQuad Open;
  ShellShaders::Variant Variant;
  std::string BlendSource;
  vtkShaderProgram* Elements = nullptr;
  unsigned int Query = 0;
  bool HasLast = false;
  vtkIdType NumberOfElements = 0;
  int NumberOfShells = 0;
  std::string Failure;
};

#endif
