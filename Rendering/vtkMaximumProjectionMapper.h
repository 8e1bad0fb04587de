#ifndef vtkMaximumProjectionMapper_h
#define vtkMaximumProjectionMapper_h

#include "vtkConvexCellMapper.h"

#include <memory> // for std::unique_ptr

/**
 * @class vtkMaximumProjectionMapper
 * @brief The greatest, or least, scalar along each ray, from convex cells as they are.
 *
 * Paper: Roettger and Ertl, "Cell projection of convex polyhedra", 2003, section 2. A scalar that
 * is linear along a ray's way through a cell is greatest at one of its ends: cells are not cut into
 * tetrahedra and nothing is sorted. Raster draws every face once, and where the near, the far, a
 * clipping plane or opaque geometry cuts a cell, the cell itself besides; Tiles draw cells from the
 * greatest scalar down and leave out those that cannot change a pixel.
 *
 * A pixel is the colour of the extremum times its scalar opacity, its alpha that opacity:
 * ScalarOpacityUnitDistance plays no role. The scalar is linear on each triangle of a face (faces
 * are fans from their smallest point id). Exact for cells whose scalar is linear; in others what is
 * between entry and exit is not looked at.
 *
 * Cells are left out as transparent only where every scalar of the mesh up to their greatest (for
 * the least: from their least on) is transparent: others may hide a visible one.
 *
 * The scalar is within 1e-5 of its range of a float64 ray caster (the tests' bound), save in pixels
 * within 1/64 pixel of a silhouette.
 *
 * Blend modes: maximum intensity (default) and minimum intensity.
 *
 * @sa vtkConvexCellMapper for what is honoured and reported.
 */
class VTKCELLPROJECTION_EXPORT vtkMaximumProjectionMapper : public vtkConvexCellMapper
{
public:
  static vtkMaximumProjectionMapper* New();
  vtkTypeMacro(vtkMaximumProjectionMapper, vtkConvexCellMapper);

protected:
  vtkMaximumProjectionMapper();
  ~vtkMaximumProjectionMapper() override;

  const char* GetMethodName() const override { return "MaximumProjection"; }
  bool CanDrawBlendMode(int mode) const override;
  bool NeedsTetrahedra() const override { return false; }
  bool IsOpacityPerLength() const override { return false; }
  void SortCells(CellProjectionFrame& frame) override;
  std::string FindTilesObstacle(const CellProjectionFrame& frame) const override;
  const float* DrawTiles(CellProjectionFrame& frame) override;
  bool ProjectCells(CellProjectionFrame& frame) override;
  void ReleaseBuffers(vtkWindow* window) override;

private:
  vtkMaximumProjectionMapper(const vtkMaximumProjectionMapper&) = delete;
  void operator=(const vtkMaximumProjectionMapper&) = delete;

  void UpdateTiles();

  bool FindsLeast();
  bool UploadFaceScalars(CellProjectionFrame& frame);
  bool UploadSelection();
  bool UploadCutCells(CellProjectionFrame& frame);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
