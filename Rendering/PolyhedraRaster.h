#ifndef PolyhedraRaster_h
#define PolyhedraRaster_h

#include "NumberedPoints.h"

#include <string>

class ConvexCellBuffers;
struct RasterView;
class vtkOpenGLRenderWindow;

/**
 * @class PolyhedraRaster
 * @brief Raster engine for the emission of convex cells, in one pass and any order.
 *
 * One GL point per cell; the geometry shader covers its projection with an octagon, each fragment
 * computes entry, exit and the emission between them.
 */
class PolyhedraRaster
{
public:
  bool UploadCells(const std::vector<unsigned int>& cells) { return this->Cells.Upload(cells); }

  /// Adds to the bound framebuffer. False, with the reason in GetFailure, where it cannot.
  bool Draw(vtkOpenGLRenderWindow* window, const RasterView& view, ConvexCellBuffers& buffers,
    bool averageEmission);

  void ReleaseGraphicsResources() { this->Cells.ReleaseGraphicsResources(); }
  const std::string& GetFailure() const { return this->Failure; }

private:
  NumberedPoints Cells;
  std::string Failure;
};

#endif
