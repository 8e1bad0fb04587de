/**
 * @class   vtkConvexifyFilter
 * @brief   adds imaginary cells that make a mesh convex
 *
 * Paper: Roettger, Guthe, Schieber, Ertl, Convexification of Unstructured Grids, 2004. The volume
 * between the mesh and its convex hull (or its bounding box) is cut by planes through its own
 * concave faces until every part is convex and connected. Gaps, holes, cavities and the space
 * between separate pieces are filled. With them Williams' MPVO orders any mesh that has no cycle.
 *
 * Input: vtkUnstructuredGrid of convex cells of any type. Output: the input's cells first and in
 * their order, then the imaginary cells as convex VTK_POLYHEDRON; the input's points first and
 * unmoved, then those that the cuts made. All arrays are carried; on what was added they are 0.
 * New arrays:
 * - cell array `Imaginary` (unsigned char): 1 for the cells added. They sort and are never drawn.
 * - field array `ImaginaryContacts` (vtkIdType, 5 components): one row per pair of cells that touch
 *   where an imaginary cell is involved: ids of three points of the mesh, whose plane is between
 *   the two, the cell on the side to which the triangle's normal points, the cell on the other
 *   side. The signs of these planes are exact, whatever rounding the new points have.
 *
 * Where points are added, the output's points are double. A boundary face of the mesh may touch
 * several imaginary cells, which tile it; the mesh itself is never split. Points closer to a cut
 * than 1e-12 of the mesh's diagonal are taken to lie in it. The same input gives the same output.
 *
 * An input that carries imaginary cells already is passed on as it is. Empty gives empty; an
 * aborted update gives no imaginary cells (and from VTK 9.3 on no cells at all). Warning: a
 * boundary that runs through itself (overlapping cells, T-junctions); then the cells do not fill
 * the enclosure, and the order is not proven.
 *
 * Not guaranteed: the fewest cells possible (the best cuts are a hard problem; the paper's choice
 * among NumberOfCandidateCuts is made).
 */

#ifndef vtkConvexifyFilter_h
#define vtkConvexifyFilter_h

#include "vtkCellProjectionModule.h" // for export macro
#include "vtkNew.h"                  // for vtkNew
#include "vtkSmartPointer.h"         // for vtkSmartPointer
#include "vtkUnstructuredGridAlgorithm.h"

class vtkTrivialProducer;
struct CellComplex;
struct ConvexificationResult;

class VTKCELLPROJECTION_EXPORT vtkConvexifyFilter : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkConvexifyFilter* New();
  vtkTypeMacro(vtkConvexifyFilter, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EnclosureType
  {
    CONVEX_HULL = 0,
    BOUNDING_BOX = 1
  };

  ///@{
  /**
   * What is filled: the convex hull of the mesh (the default) or its bounding box.
   */
  vtkSetClampMacro(Enclosure, int, CONVEX_HULL, BOUNDING_BOX);
  vtkGetMacro(Enclosure, int);
  void SetEnclosureToConvexHull() { this->SetEnclosure(CONVEX_HULL); }
  void SetEnclosureToBoundingBox() { this->SetEnclosure(BOUNDING_BOX); }
  ///@}

  enum FillMethodType
  {
    CUTS = 0,
    ALGORITHM = 1
  };

  ///@{
  /**
   * Who makes the imaginary cells: the cutting planes of the paper (the default), or the
   * FillAlgorithm, which fills the convex hull whatever the Enclosure is.
   */
  vtkSetClampMacro(FillMethod, int, CUTS, ALGORITHM);
  vtkGetMacro(FillMethod, int);
  void SetFillMethodToCuts() { this->SetFillMethod(CUTS); }
  void SetFillMethodToAlgorithm() { this->SetFillMethod(ALGORITHM); }
  ///@}

  ///@{
  /**
   * For FillMethod Algorithm: any that gives back the cells of its input, then imaginary ones, with
   * the arrays above, such as vtkTetGenTetrahedralizer in its mode FillHull (a library of its own,
   * which this one does not need). Its first input is connected here. Where it is missing, or adds
   * no array `Imaginary`, an error says so, and cuts are made. Default: none.
   */
  void SetFillAlgorithm(vtkUnstructuredGridAlgorithm* algorithm);
  vtkUnstructuredGridAlgorithm* GetFillAlgorithm() { return this->FillAlgorithm; }
  ///@}

  /**
   * Of the FillAlgorithm, too.
   */
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * How many cuts are compared before one is made. More give fewer cells. Default: 20.
   */
  vtkSetClampMacro(NumberOfCandidateCuts, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfCandidateCuts, int);
  ///@}

  ///@{
  /**
   * Leave out cells that lie outside of the convex hull: no ray between two cells of the mesh meets
   * them. Matters for the bounding box alone. Default: on.
   */
  vtkSetMacro(DiscardOutsideHull, bool);
  vtkGetMacro(DiscardOutsideHull, bool);
  vtkBooleanMacro(DiscardOutsideHull, bool);
  ///@}

  // === What the last update did ===

  /**
   * Cells added.
   */
  vtkGetMacro(NumberOfImaginaryCells, vtkIdType);

  /**
   * Cells that were left out for they lie outside of the convex hull.
   */
  vtkGetMacro(NumberOfDiscardedCells, vtkIdType);

  /**
   * Faces per cell added, in the mean.
   */
  vtkGetMacro(FacesPerImaginaryCell, double);

  /**
   * True where the mesh fills its convex hull by itself.
   */
  vtkGetMacro(InputConvex, bool);

  ///@{
  /**
   * Volumes, of the cells added, of those left out, of the hull or box with the mesh in it.
   */
  vtkGetMacro(ImaginaryVolume, double);
  vtkGetMacro(DiscardedVolume, double);
  vtkGetMacro(EnclosureVolume, double);
  ///@}

  /**
   * Wall-clock seconds of the last update.
   */
  vtkGetMacro(Seconds, double);

protected:
  vtkConvexifyFilter();
  ~vtkConvexifyFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkConvexifyFilter(const vtkConvexifyFilter&) = delete;
  void operator=(const vtkConvexifyFilter&) = delete;

  bool FillByAlgorithm(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output);
  void FillByCuts(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output);
  ConvexificationResult Convexify(const CellComplex& complex);
  void Report(const CellComplex& complex, const ConvexificationResult& result);

  int Enclosure = CONVEX_HULL;
  int FillMethod = CUTS;
  vtkSmartPointer<vtkUnstructuredGridAlgorithm> FillAlgorithm;
  // Hands the input on to it, so that it has not changed where the input has not.
  vtkNew<vtkTrivialProducer> FillInput;
  int NumberOfCandidateCuts = 20;
  bool DiscardOutsideHull = true;

  vtkIdType NumberOfImaginaryCells = 0;
  vtkIdType NumberOfDiscardedCells = 0;
  double FacesPerImaginaryCell = 0.0;
  bool InputConvex = false;
  double ImaginaryVolume = 0.0;
  double DiscardedVolume = 0.0;
  double EnclosureVolume = 0.0;
  double Seconds = 0.0;
};

#endif
