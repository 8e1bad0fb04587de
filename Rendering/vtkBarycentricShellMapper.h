#ifndef vtkBarycentricShellMapper_h
#define vtkBarycentricShellMapper_h

#include "vtkConvexCellMapper.h"

#include <memory> // for std::unique_ptr
#include <string> // for messages

class vtkVisibilitySort;

/**
 * @class vtkBarycentricShellMapper
 * @brief Absorption and emission of meshes whose points move: no sort, no preprocessing.
 *
 * Paper: Georgii and Westermann, "A generic and scalable pipeline for GPU tetrahedral grid
 * rendering", 2006. The space around the eye is cut into shells, spheres in perspective and planes
 * in parallel projection. From front to back, the tetrahedra that overlap a shell are drawn in any
 * order, each sampled on the slices of the shell in its own barycentric coordinates, and the
 * samples are classified and composited. The GPU holds points and scalars only.
 *
 * With Integration Point the image is a sum over slices, each of which stands for a whole step: its
 * error is of first order in the distance between them, that of up to half a step where a ray enters
 * and leaves the mesh, and no placing of the slices makes it less. PreIntegrated takes the exact
 * integral between neighbouring slices, from and to where the mesh begins and ends, as if the scalar
 * were linear between: second order. A ray that leaves the mesh and enters it again within two
 * slices may be off by one of them, and the greatest scalar counts where cells overlap. Against the
 * exact integral, for optical depths of up to 3.5 and up to 20 along the mesh's diagonal:
 *
 *     samples per ray         RMSE              largest error
 *     Point            600    8e-4, 1.6e-3      5e-3, 1.6e-2
 *     Point           1200    4e-4, 8e-4        2e-3, 6e-3
 *     PreIntegrated    600    8e-6, 2e-5        1e-4, 3e-4
 *
 * Cells that hide each other in a circle, concave meshes and gaps need nothing special. Where
 * points alone move, points alone are sent to the GPU: cells stay as they were first cut up
 * (vtkConvexCells, KeepCells).
 *
 * Blend modes: composite, and isosurface: the surfaces where the scalar is one of the property's
 * IsoSurfaceValues, found exactly in every cell, with the colour and the ScalarOpacity of their
 * value (no unit distance), in any number and order. With Shade on they are lit by all lights, with
 * normals from gradients at the points. The nearest surface writes its depth to the window where
 * its opacity is 1. A gradient opacity takes its part of each point's. Where all of them are opaque,
 * they are drawn as triangles, made on all threads where scalars change; where points move, only the
 * triangles' vertices move. Unless an image is captured, they go straight into the window.
 *
 * One component is drawn, the colour function's (SetVectorModeToComponent) or the magnitude:
 * dependent components (IndependentComponentsOff) are named by one warning, for surfaces too.
 *
 * @sa vtkConvexCellMapper for what is honoured and reported.
 */
class VTKCELLPROJECTION_EXPORT vtkBarycentricShellMapper : public vtkConvexCellMapper
{
public:
  static vtkBarycentricShellMapper* New();
  vtkTypeMacro(vtkBarycentricShellMapper, vtkConvexCellMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The distance between two slices in world lengths, or how many of them the diagonal of the mesh
   * is long. Of the two the one set last counts. Must be positive; a frame that would take more
   * than 65,536 slices is refused with their number. Default: 400 samples per ray.
   */
  virtual void SetSampleDistance(double distance);
  vtkGetMacro(SampleDistance, double);
  virtual void SetSamplesPerRay(double samples);
  vtkGetMacro(SamplesPerRay, double);
  ///@}

  ///@{
  /**
   * How many slices are sampled at once: 4, 8 or 16, in one, two or four float targets of four
   * components. The image is the same; fewer tetrahedra are drawn twice with more, and more samples
   * of those that are thinner than a shell come to nothing. Default: 8.
   */
  virtual void SetSamplesPerShell(int samples);
  vtkGetMacro(SamplesPerShell, int);
  ///@}

  enum MethodType
  {
    SHELLS = 0,
    CELL_PROJECTION = 1
  };

  ///@{
  /**
   * How absorption and emission are drawn. Shells: sampled, in no order. CellProjection: each
   * tetrahedron from its entry to its exit by the exact integral, from back to front (the paper's
   * section 5); cells that hide each other in a circle are put in order per pixel. Where the driver
   * cannot blend floats to their maximum, CellProjection is drawn. Default: Shells.
   */
  vtkSetClampMacro(Method, int, SHELLS, CELL_PROJECTION);
  vtkGetMacro(Method, int);
  void SetMethodToShells() { this->SetMethod(SHELLS); }
  void SetMethodToCellProjection() { this->SetMethod(CELL_PROJECTION); }
  ///@}

  ///@{
  /**
   * What orders the tetrahedra for CellProjection; the paper's is vtkPowerVisibilitySort. Null
   * chooses: that one where it is exact, else vtkMPVOVisibilitySort. Default: null.
   */
  virtual void SetVisibilitySort(vtkVisibilitySort* sort);
  vtkVisibilitySort* GetVisibilitySort();
  ///@}

  enum IntegrationType
  {
    POINT = 0,
    PRE_INTEGRATED = 1
  };

  ///@{
  /**
   * What a sample stands for. Point: its slice, as in the paper. PreIntegrated: the exact integral
   * to the next sample. Default: PreIntegrated.
   */
  vtkSetClampMacro(Integration, int, POINT, PRE_INTEGRATED);
  vtkGetMacro(Integration, int);
  void SetIntegrationToPoint() { this->SetIntegration(POINT); }
  void SetIntegrationToPreIntegrated() { this->SetIntegration(PRE_INTEGRATED); }
  ///@}

  ///@{
  /**
   * An image that is bound to the mesh: the scalar at a sample is the image's at the texture
   * coordinates there, three for each point (SetTCoords of the input's point data), linear in each
   * tetrahedron; 0 and 1 are the image's first and last points. The coordinates stay where points
   * move. The scalars of the mesh play no role, and all cells are drawn. Iso-surfaces of an image,
   * which is not linear in a cell, are refused with an error: give the points scalars for them
   * (vtkProbeFilter). CellProjection takes the image at entry and exit alone. Default: null.
   */
  virtual void SetVolumeTexture(vtkImageData* image);
  vtkImageData* GetVolumeTexture();
  ///@}

  ///@{
  /**
   * How many MiB of points and scalars may be on the GPU at once; 0 is no limit. A mesh that takes
   * more is drawn in shells block by block: each shell sends the blocks that it overlaps, and the
   * image is the same to the last bit. Other methods take the whole mesh. Default: 0.
   */
  virtual void SetMemoryLimit(double limit);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /**
   * About the last frame: how many tetrahedra were drawn in shells, each counted once per shell that
   * it overlaps; how many shells there were until all pixels were opaque; both and the bytes of
   * their targets are 0 where nothing was drawn in shells. How many tetrahedra moved points have
   * turned inside out since they got their cells (they are drawn as they are; among the cells that
   * opaque iso-surfaces cut, those alone); bytes of points and scalars, or of triangles, on the GPU,
   * and what was sent of them.
   */
  vtkIdType GetNumberOfElementsDrawn() const;
  int GetNumberOfShells() const;
  vtkIdType GetMeshBytes() const;
  vtkIdType GetTargetBytes() const;
  vtkIdType GetUploadedBytes() const;
  double GetUploadSeconds() const;
  vtkIdType GetNumberOfTurnedCells() const;
  ///@}

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

protected:
  vtkBarycentricShellMapper();
  ~vtkBarycentricShellMapper() override;

  const char* GetMethodName() const override;
  bool CanDrawBlendMode(int mode) const override
  {
    return mode == COMPOSITE || mode == ISOSURFACE;
  }
  bool NeedsTetrahedra() const override { return true; }
  bool CanShade() const override { return this->BlendMode == ISOSURFACE; }
  bool CanDepend() const override { return false; }
  vtkDataArray* GetOwnScalars() override;
  bool IsOpacityPerLength() const override { return this->BlendMode != ISOSURFACE; }
  bool KeepsCells() const override
  {
    return this->Method == SHELLS || this->BlendMode == ISOSURFACE;
  }
  void SortCells(CellProjectionFrame& frame) override;
  bool DrawsIntoWindow() const override;
  bool ProjectCells(CellProjectionFrame& frame) override;
  void ReleaseBuffers(vtkWindow* window) override;

private:
  vtkBarycentricShellMapper(const vtkBarycentricShellMapper&) = delete;
  void operator=(const vtkBarycentricShellMapper&) = delete;

  void SelectCells(CellProjectionFrame& frame);
  bool MakeTriangles(CellProjectionFrame& frame);
  void WarnOfTurnedCells(vtkIdType before);
  void OrderCells(CellProjectionFrame& frame);
  bool CheckTexture();
  bool UploadMesh(CellProjectionFrame& frame, bool inShells);
  bool PlanShells(CellProjectionFrame& frame);

  double SampleDistance = 0.0;
  double SamplesPerRay = 400.0;
  int SamplesPerShell = 8;
  int Integration = PRE_INTEGRATED;
  int Method = SHELLS;
  double MemoryLimit = 0.0;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
