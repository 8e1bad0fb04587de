#ifndef ThreePassRaster_h
#define ThreePassRaster_h

#include "EmptyVertexArray.h"
#include "PassTriangles.h"
#include "TextureBuffer.h"
#include "vtkTimeStamp.h"

#include <string>
#include <vector>

class ConvexCellBuffers;
class PreparedPolyhedra;
struct PreparedVolume;
struct RasterView;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class ThreePassRaster
 * @brief Raster engine for the emission of convex cells as the paper has it: three passes per cell.
 *
 * Paper: Roettger and Ertl, "Cell projection of convex polyhedra", 2003, section 3. Back faces add
 * their depth to the alpha channel and front faces subtract theirs, which leaves the length inside
 * the cell; then all faces add their emission times that. Depths count from the cell's centre, as a
 * share of twice its radius. The target is float and so may be below zero: lengths need one pass
 * over the surface, in any order, and a third one takes them back for the next cell. One draw call
 * does it for all cells, as GL keeps the order of triangles.
 *
 * Depth and scalar are those of the ray in the triangle's own plane: interpolated by a GPU, which
 * moves corners to a grid of 1/256 pixel, they were wrong by up to .005 in one of 14 pixels.
 *
 * Cells that the near plane cuts are cut before they are drawn, and closed by a cap; those behind
 * it are left out.
 */
class ThreePassRaster
{
public:
  /// Adds to the bound framebuffer and leaves its alpha 0. False, with the reason in GetFailure,
  /// where it cannot.
  bool Draw(vtkOpenGLRenderWindow* window, const RasterView& view, const PreparedVolume& prepared,
    PreparedPolyhedra& polyhedra);

  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetFailure() const { return this->Failure; }

private:
  struct Ranges
  {
    std::vector<int> First;
    std::vector<int> Count;
  };
  bool Update(vtkOpenGLRenderWindow* window, const PreparedPolyhedra& polyhedra);
  bool Cut(vtkOpenGLRenderWindow* window, const RasterView& view, const PreparedVolume& prepared,
    const PreparedPolyhedra& polyhedra);
  /// All but those two lists.
  Ranges FindWholeCells(
    const std::vector<unsigned int>& cut, const std::vector<unsigned int>& behind) const;
  static void SetUniforms(vtkShaderProgram* program, const RasterView& view);
  static void ClearAlpha(vtkOpenGLRenderWindow* window);
  void DrawRanges(vtkShaderProgram* program, TextureBuffer& triangles, const Ranges& ranges);
  bool Check(const TextureBuffer& buffer, bool uploaded);

  PassTriangles Whole;
  vtkTimeStamp WholeTime;
  vtkTimeStamp WholeUploaded;
  Ranges WholeRanges;
  Ranges CutRanges;
  TextureBuffer WholeTriangles;
  TextureBuffer CutTriangles;
  TextureBuffer CutVertices;
  EmptyVertexArray VertexArray;
  std::string Failure;
};

#endif
