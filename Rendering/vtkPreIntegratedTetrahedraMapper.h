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
   * section 8), built again when the transfer function changes; where the driver has no room for it
   * one warning says so and Exact is drawn. Average: the mean of colour and extinction at both ends
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

protected:
  vtkPreIntegratedTetrahedraMapper();
  ~vtkPreIntegratedTetrahedraMapper() override;

  const char* GetMethodName() const override { return "PreIntegratedTetrahedra"; }
  bool CanDrawBlendMode(int mode) const override { return mode == COMPOSITE; }
  bool NeedsTetrahedra() const override { return true; }
  void SortCells(CellProjectionFrame& frame) override;
  bool ProjectCells(CellProjectionFrame& frame) override;
  void ReleaseBuffers(vtkWindow* window) override;

private:
  vtkPreIntegratedTetrahedraMapper(const vtkPreIntegratedTetrahedraMapper&) = delete;
  void operator=(const vtkPreIntegratedTetrahedraMapper&) = delete;

  void PrepareTetrahedra(CellProjectionFrame& frame);
  bool UploadCells(CellProjectionFrame& frame);
  bool UploadField(CellProjectionFrame& frame);
  bool UploadOrder();
  bool UploadTable(CellProjectionFrame& frame);

  int Integration = EXACT;
  int TableSize = 128;
  int SamplesPerSegment = 1;
  bool ReportOrder = false;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
