#ifndef TetrahedraRaster_h
#define TetrahedraRaster_h

#include "DepthLayers.h"
#include "DrawnCells.h"
#include "EmptyVertexArray.h"
#include "PreIntegrationTexture.h"
#include "RasterView.h"
#include "TetrahedraShaders.h"
#include "TextureBuffer.h"
#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"

#include <array>
#include <string>
#include <vector>

class PreIntegrationTable;
class ShadingBuffers;
class TransferFunction;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class TetrahedraRaster
 * @brief Raster engine for tetrahedra: emission and absorption, drawn from back to front.
 *
 * One GL point per cell; the geometry shader sets up the cell's four planes once and covers its
 * projection with two triangles, each fragment computes entry, exit and the integral between them.
 * Points, corners, scalars and transfer function stay on the GPU; a new eye uploads an order alone.
 * Cells that hide each other in a circle are put in order per pixel (class DepthLayers): two draws
 * of the group for every layer of it, and none of this where there is no such group.
 *
 * Array shapes: points 4 floats each (xyz in mesh coordinates, one unused), corners 4 ids per cell
 * in ascending order, scalars one per point or per cell in [0,1], order one index per drawn cell.
 */
class TetrahedraRaster
{
public:
  bool UploadPoints(vtkOpenGLRenderWindow* window, const std::vector<float>& points);
  bool UploadCorners(vtkOpenGLRenderWindow* window, const std::vector<int>& corners);
  bool UploadPlanes(vtkOpenGLRenderWindow* window, const std::vector<float>& planes);
  bool UploadScalars(vtkOpenGLRenderWindow* window, const std::vector<float>& scalars);
  bool UploadTransferFunction(vtkOpenGLRenderWindow* window, const TransferFunction& function);
  bool UploadOrder(const DrawnCells& cells);
  /// False where the driver has no room for it.
  bool UploadTable(vtkOpenGLRenderWindow* window, const PreIntegrationTable& table)
  {
    return this->Table.Upload(window, table);
  }

  struct View : RasterView
  {
    SegmentIntegration Integration = SegmentIntegration::Exact;
    /// With a table: in how many parts a segment is looked up, at least.
    int SamplesPerSegment = 1;
    /// Null where the volume is not lit and has no gradient opacity.
    ShadingBuffers* Shading = nullptr;
    /// What was uploaded, for the box of a cyclic group on the screen.
    const DrawnCells* Cells = nullptr;
    const std::vector<float>* Points = nullptr;
    const std::vector<int>* Corners = nullptr;
  };

  /// Draws into the bound framebuffer. False, with the reason in GetFailure, where it cannot.
  bool Draw(vtkOpenGLRenderWindow* window, const View& view);

  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetFailure() const { return this->Failure; }

private:
  struct NamedBuffer
  {
    TextureBuffer* Buffer;
    const char* Sampler;
  };
  std::array<NamedBuffer, 6> GetBuffers();
  /// What draws: all cells as they come, or of cyclic groups the next layer and its colour.
  struct Programs
  {
    vtkShaderProgram* Cells = nullptr;
    vtkShaderProgram* Search = nullptr;
    vtkShaderProgram* Layer = nullptr;
  };
  bool BuildPrograms(
    vtkOpenGLRenderWindow* window, const View& view, bool withLayers, Programs& programs);
  bool BeginCells(vtkOpenGLRenderWindow* window, const View& view, Programs& programs);
  void EndCells(const View& view, const Programs& programs);
  void DrawRun(const DrawnCells::Run& run);
  void DrawGroup(const DrawnCells::Run& run, const View& view, const Programs& programs);
  void SetUniforms(vtkShaderProgram* program, const View& view);
  bool Check(const TextureBuffer& buffer, bool uploaded);

  TextureBuffer Points;
  TextureBuffer Corners;
  TextureBuffer Planes;
  TextureBuffer Scalars;
  TextureBuffer NodePositions;
  TextureBuffer NodeValues;
  PreIntegrationTexture Table;
  vtkNew<vtkOpenGLBufferObject> Order;
  DepthLayers Layers;
  EmptyVertexArray VertexArray;
  int NumberOfNodes = 0;
  std::string Failure;
};

#endif
