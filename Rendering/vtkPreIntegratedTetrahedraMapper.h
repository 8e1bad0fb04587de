#ifndef vtkPreIntegratedTetrahedraMapper_h
#define vtkPreIntegratedTetrahedraMapper_h

#include "vtkConvexCellMapper.h"

#include <memory> // for std::unique_ptr

class vtkVisibilitySort;

/**
 * @class vtkPreIntegratedTetrahedraMapper
 * @brief Absorption and emission by exact projected tetrahedra.
 *
 * Every cell is cut into tetrahedra (vtkConvexCells), these are sorted from back to front and each
 * is projected, by default with the exact integral of emission and absorption: entry and exit from
 * the cell's four planes, split at the transfer function's points, exact alpha, Gauss quadrature in
 * the colour. After Roettger and Ertl, "Cell projection of convex polyhedra", 2003, and Roettger,
 * Guthe, Schieber and Ertl, "Convexification of unstructured grids", 2004, section 8.
 *
 * Where the order is right the image is within 1e-3 of a float64 ray caster (the tests' bound).
 * The order is that of the visibility sort; by default one that is right for any mesh of cells that
 * do not overlap. Cells that a vtkProvenVisibilitySort names as hiding each other in a circle are
 * put in order per pixel, after Kraus and Ertl, "Cell-projection of cyclic meshes", 2001, here by
 * peeling: a group of up to 1,500 is drawn twice for every cell that lies behind another in it at
 * some pixel.
 *
 * With the property's Shade on, the emission is lit by all lights of the renderer (the first 16),
 * after the model of vtkGPUVolumeRayCastMapper, two-sided:
 *
 *     kappa (ambient sum(light) + diffuse sum(light |n.l|)) + specular sum(light (r.v)^power)
 *
 * with n the gradient: at points the mean of the tetrahedra around them by volume, linear in
 * between, of unit length where it is taken. Where it is zero (constant scalars, cell scalars) the
 * ambient term is all there is. A light is its diffuse (specular) colour times its intensity, with
 * the attenuation and the cone of a positional light; its own ambient colour is added to the
 * ambient sum. A gradient opacity function takes the length of the gradient in the world. Exact
 * integrates both over the cell, within 1e-3; Table looks light up at two places of each part of a
 * segment and cuts parts where it turns (three textures instead of one, the error of the unlit
 * table); Average takes both at the ends.
 *
 * @sa vtkConvexCellMapper for what is honoured and reported.
 */
class VTKCELLPROJECTION_EXPORT vtkPreIntegratedTetrahedraMapper : public vtkConvexCellMapper
{
public:
  static vtkPreIntegratedTetrahedraMapper* New();
  vtkTypeMacro(vtkPreIntegratedTetrahedraMapper, vtkConvexCellMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What orders the tetrahedra. Its input is the output of a vtkConvexCells with TetrahedraOnly on.
   * Null chooses: vtkPowerVisibilitySort where that is exact (convex
   * Delaunay meshes), else vtkMPVOVisibilitySort. Default: null.
   */
  virtual void SetVisibilitySort(vtkVisibilitySort* sort);
  vtkVisibilitySort* GetVisibilitySort();
  ///@}

  enum IntegrationType
  {
    EXACT = 0,
    TABLE = 1,
    AVERAGE = 2
  };

  ///@{
  /**
   * How emission and absorption between entry and exit of a cell are found. Exact: split at the
   * transfer function's points. Table: looked up in a pre-integration table (Roettger et al. 2004,
   * section 8), built again when the transfer function changes; where memory or the driver has no room
   * for it one warning says so and Exact is drawn. Average: the mean of colour and extinction at both ends
   * (Shirley and Tuchman 1990), which misses what the transfer function does between them.
   * Default: Exact.
   */
  vtkSetClampMacro(Integration, int, EXACT, AVERAGE);
  vtkGetMacro(Integration, int);
  void SetIntegrationToExact() { this->SetIntegration(EXACT); }
  void SetIntegrationToTable() { this->SetIntegration(TABLE); }
  void SetIntegrationToAverage() { this->SetIntegration(AVERAGE); }
  ///@}

  ///@{
  /**
   * N of a table of N x N x N / 4 entries of 16 bytes: scalars at front and back, length. Its error
   * is of first order in 1 / N. Default: 128.
   */
  vtkSetClampMacro(TableSize, int, 32, 256);
  vtkGetMacro(TableSize, int);
  ///@}

  ///@{
  /**
   * In how many parts a cell's segment is looked up in the table, at least. Default: 1.
   */
  vtkSetClampMacro(SamplesPerSegment, int, 1, 16);
  vtkGetMacro(SamplesPerSegment, int);
  ///@}

  enum ApproximationType
  {
    NONE = 0,
    SHIRLEY_TUCHMAN = 1,
    SHIRLEY_TUCHMAN_EXPONENTIAL = 2,
    VOXEL = 3,
    UNIFORM_THICKNESS_1 = 4,
    UNIFORM_THICKNESS_2 = 5,
    CENTROID = 6
  };

  ///@{
  /**
   * Draw cells as triangles with colour and opacity at their corners, as the literature did before
   * there were fragment shaders; overrides Integration and the engine. None: no approximation.
   * ShirleyTuchman (1990): triangles about the thickest point, opacity linear.
   * ShirleyTuchmanExponential (Stein, Becker and Max 1994): length and extinction linear, the
   * exponential per pixel. Voxel, UniformThickness1, UniformThickness2 (Williams 1992) and Centroid
   * as in Cignoni, Montani, Sarti and Scopigno 1995, section 3.2; the thickness that the first
   * three give to every cell is the mean chord of the mesh's cells.
   *
   * What these can do with the scene: the near plane cuts cells, and of the cells that the far
   * plane, clipping planes or opaque geometry cut, their thickness counts as far as it is seen, in
   * one colour. What they cannot: cells that hide each other in a circle are drawn as the sort left
   * them, with one warning. Between corners the transfer function is not seen. Default: None.
   */
  vtkSetClampMacro(Approximation, int, NONE, CENTROID);
  vtkGetMacro(Approximation, int);
  void SetApproximationToNone() { this->SetApproximation(NONE); }
  void SetApproximationToShirleyTuchman() { this->SetApproximation(SHIRLEY_TUCHMAN); }
  void SetApproximationToShirleyTuchmanExponential()
  {
    this->SetApproximation(SHIRLEY_TUCHMAN_EXPONENTIAL);
  }
  void SetApproximationToVoxel() { this->SetApproximation(VOXEL); }
  void SetApproximationToUniformThickness1() { this->SetApproximation(UNIFORM_THICKNESS_1); }
  void SetApproximationToUniformThickness2() { this->SetApproximation(UNIFORM_THICKNESS_2); }
  void SetApproximationToCentroid() { this->SetApproximation(CENTROID); }
  ///@}

  ///@{
  /**
   * Of Centroid: a cell's thickness over the radius of its inscribed sphere, the paper's c1, which
   * found 2.5 to 3 best. Default: 2.75.
   */
  vtkSetClampMacro(CentroidThickness, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CentroidThickness, double);
  ///@}

  ///@{
  /**
   * Of Centroid: the opacity at the rim of a cell's projection over that in its middle, in the
   * paper 0.3. Default: 0.3.
   */
  vtkSetClampMacro(CentroidRimOpacity, double, 0.0, 1.0);
  vtkGetMacro(CentroidRimOpacity, double);
  ///@}

  ///@{
  /**
   * Count the shared faces that came out in the wrong order (column MisorderedFaces of the
   * statistics), for every new order; a sort that cannot say so counts none. Faces inside a group
   * that no order satisfies count too, though they are drawn right. Default: off, and then it costs
   * nothing.
   */
  vtkSetMacro(ReportOrder, bool);
  vtkGetMacro(ReportOrder, bool);
  vtkBooleanMacro(ReportOrder, bool);
  ///@}

  ///@{
  /**
   * Have the Tiles engine time its stages and count what they did, as further columns of the
   * statistics. SecondsCull, SecondsTransform, SecondsBox (boxes of cells, signs of faces), SecondsBin
   * (lists of tiles); within tiles, the mean of all threads: SecondsOrder, SecondsSetUp (planes),
   * SecondsCover, SecondsShade, SecondsComposite, SecondsRepair (pixels found and sorted), SecondsWrite,
   * SecondsWait (for the last tile); Threads; CellsInTiles (one for every tile of a cell), CellsHidden
   * (of these, behind what is opaque), Fragments (rays in cells), Pieces (of fragments, cut where the
   * function bends); LanesOfBlocks and LanesCovered (of vectors of pixels, and those in a cell),
   * LanesShaded (of vectors of pieces); BytesOfMesh and BytesOfFrame (memory of the engine that lasts,
   * and that a frame needs). A frame takes up to a twentieth longer. Default: off, and then it costs
   * nothing.
   */
  vtkSetMacro(ReportStages, bool);
  vtkGetMacro(ReportStages, bool);
  vtkBooleanMacro(ReportStages, bool);
  ///@}

protected:
  vtkPreIntegratedTetrahedraMapper();
  ~vtkPreIntegratedTetrahedraMapper() override;

  const char* GetMethodName() const override;
  bool CanDrawBlendMode(int mode) const override { return mode == COMPOSITE; }
  bool NeedsTetrahedra() const override { return true; }
  bool CanShade() const override { return this->Approximation == NONE; }
  void SortCells(CellProjectionFrame& frame) override;
  std::string FindTilesObstacle(const CellProjectionFrame& frame) const override;
  const float* DrawTiles(CellProjectionFrame& frame) override;
  bool ProjectCells(CellProjectionFrame& frame) override;
  void ReleaseBuffers(vtkWindow* window) override;

  /// When the table was built last; 0 where it never was.
  vtkMTimeType GetTableTime() const;

private:
  vtkPreIntegratedTetrahedraMapper(const vtkPreIntegratedTetrahedraMapper&) = delete;
  void operator=(const vtkPreIntegratedTetrahedraMapper&) = delete;

  void PrepareTetrahedra(CellProjectionFrame& frame);
  void OrderCells(CellProjectionFrame& frame);
  bool UploadCells(CellProjectionFrame& frame);
  bool UploadField(CellProjectionFrame& frame);
  bool UploadOrder();
  bool UploadTable(CellProjectionFrame& frame);
  bool DrawsTable();
  void BuildDrawnCells();
  void PrepareApproximation(CellProjectionFrame& frame);
  bool ProjectApproximation(CellProjectionFrame& frame);
  bool Fail(CellProjectionFrame& frame, const std::string& reason);
  bool UploadShading(CellProjectionFrame& frame);

  int Integration = EXACT;
  int TableSize = 128;
  int SamplesPerSegment = 1;
  int Approximation = NONE;
  double CentroidThickness = 2.75;
  double CentroidRimOpacity = 0.3;
  bool ReportOrder = false;
  bool ReportStages = false;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
