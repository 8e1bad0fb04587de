#ifndef MaximumRaster_h
#define MaximumRaster_h

#include "ExtremumTarget.h"
#include "NumberedPoints.h"
#include "TextureBuffer.h"

#include <string>
#include <vector>

class ConvexCellBuffers;
struct RasterView;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class MaximumRaster
 * @brief Raster engine for the greatest, or least, scalar along each ray.
 *
 * A scalar that is linear between entry and exit is greatest at one of them, so it is enough to
 * draw every face once, blended to the maximum of a float. Cells that the near, the far or a
 * clipping plane cuts have ends that are on no face: they are drawn as cells besides, and where
 * there is opaque geometry so are all.
 */
class MaximumRaster
{
public:
  /// Four per piece, where scalars are those of cells; else empty.
  bool UploadFaceScalars(vtkOpenGLRenderWindow* window, const std::vector<float>& scalars);
  bool UploadFaces(const std::vector<unsigned int>& pieces) { return this->Faces.Upload(pieces); }
  bool UploadCells(const std::vector<unsigned int>& cells) { return this->Cells.Upload(cells); }
  bool UploadCutCells(const std::vector<unsigned int>& cells) { return this->Cut.Upload(cells); }

  /// Draws premultiplied colours to the bound framebuffer. False, with the reason in GetFailure,
  /// where it cannot.
  bool Draw(vtkOpenGLRenderWindow* window, const RasterView& view, ConvexCellBuffers& buffers,
    bool findLeast);

  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetFailure() const { return this->Failure; }

private:
  bool FindExtrema(vtkOpenGLRenderWindow* window, const RasterView& view,
    ConvexCellBuffers& buffers, bool findLeast);
  void DrawFaces(vtkShaderProgram* program, const RasterView& view, ConvexCellBuffers& buffers);
  void DrawCells(vtkShaderProgram* program, const RasterView& view, ConvexCellBuffers& buffers,
    NumberedPoints& cells);

  TextureBuffer FaceScalars;
  bool HasFaceScalars = false;
  NumberedPoints Faces;
  NumberedPoints Cells;
  NumberedPoints Cut;
  ExtremumTarget Target;
  std::string Failure;
};

#endif
