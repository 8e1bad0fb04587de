#ifndef vtkProjectedPolyhedraMapper_h
#define vtkProjectedPolyhedraMapper_h

#include "vtkConvexCellMapper.h"

#include <memory> // for std::unique_ptr

/**
 * @class vtkProjectedPolyhedraMapper
 * @brief Emission without absorption from convex cells as they are: fog, fire, light.
 *
 * Paper: Roettger and Ertl, "Cell projection of convex polyhedra", 2003. Nothing hides anything, so
 * cells are drawn in any order and nothing is sorted; hexahedra, wedges, pyramids, prisms and
 * polyhedra are not cut into tetrahedra, save the few that are not convex (vtkConvexCells).
 *
 * A pixel is the integral of colour times extinction along its ray, in world lengths; its alpha is
 * 0, so it is added to what is behind. The scalar is linear on each triangle of a face (faces are
 * fans from their smallest point id) and linear between a ray's entry and exit. On slightly warped
 * faces, as curvilinear grids have them, this holds triangle by triangle; a ray that leaves such a
 * cell and enters it again counts as inside from its first to its last point.
 *
 * With one pass the image is within 1e-4 of a float64 ray caster (the tests' bound; most are within
 * 6e-6). Three passes are the paper's: back faces add their depth to the alpha channel, front faces
 * subtract theirs, then every face adds its emission times that length. There the emission of a
 * cell is the mean of both ends, which is exact to 6e-5 where it is linear in between, and off by
 * the trapezoid rule elsewhere; coverage is the rasteriser's. Cells with dents (warped faces) count
 * some emission twice where a ray leaves and enters them again. Where the far plane, a clipping
 * plane or opaque geometry cuts a cell its ends keep the emission of its faces; at the near plane
 * they have that of the cut.
 *
 * Blend mode: additive, no other.
 *
 * @sa vtkConvexCellMapper for what is honoured and reported.
 */
class VTKCELLPROJECTION_EXPORT vtkProjectedPolyhedraMapper : public vtkConvexCellMapper
{
public:
  static vtkProjectedPolyhedraMapper* New();
  vtkTypeMacro(vtkProjectedPolyhedraMapper, vtkConvexCellMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PassesType
  {
    ONE = 1,
    THREE = 3
  };

  ///@{
  /**
   * How often a cell is drawn. One is exact and faster; Three is the paper's, by Raster alone.
   * Default: One.
   */
  virtual void SetPasses(int passes);
  vtkGetMacro(Passes, int);
  void SetPassesToOne() { this->SetPasses(ONE); }
  void SetPassesToThree() { this->SetPasses(THREE); }
  ///@}

  ///@{
  /**
   * Take the mean of the emission at entry and exit, as the paper does, instead of the integral:
   * right where the transfer function is linear between them. Three passes always do. By Raster
   * alone. Default: off.
   */
  vtkSetMacro(AverageEmission, bool);
  vtkGetMacro(AverageEmission, bool);
  vtkBooleanMacro(AverageEmission, bool);
  ///@}

protected:
  vtkProjectedPolyhedraMapper();
  ~vtkProjectedPolyhedraMapper() override;

  const char* GetMethodName() const override;
  bool CanDrawBlendMode(int mode) const override { return mode == ADDITIVE; }
  bool NeedsTetrahedra() const override { return false; }
  void SortCells(CellProjectionFrame& frame) override;
  std::string FindTilesObstacle(const CellProjectionFrame& frame) const override;
  const float* DrawTiles(CellProjectionFrame& frame) override;
  bool ProjectCells(CellProjectionFrame& frame) override;
  void ReleaseBuffers(vtkWindow* window) override;

private:
  vtkProjectedPolyhedraMapper(const vtkProjectedPolyhedraMapper&) = delete;
  void operator=(const vtkProjectedPolyhedraMapper&) = delete;

  void UpdateTiles();

  bool DrawOnePass(CellProjectionFrame& frame);

  int Passes = ONE;
  bool AverageEmission = false;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
