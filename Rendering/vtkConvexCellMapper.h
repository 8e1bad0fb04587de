#ifndef vtkConvexCellMapper_h
#define vtkConvexCellMapper_h

#include "vtkCellProjectionModule.h" // for export macro
#include "vtkUnstructuredGridBase.h" // for SetInputData
#include "vtkUnstructuredGridVolumeMapper.h"

#include <memory> // for std::unique_ptr
#include <string> // for messages

class vtkDataArray;
class vtkImageData;
class vtkRenderWindow;
class vtkTable;
struct CellProjectionFrame;
struct PreparedVolume;

/**
 * @class vtkConvexCellMapper
 * @brief What every mapper that projects convex cells shares. Abstract.
 *
 * The stages of a frame: check the input, cut it into convex cells, take scalars and transfer
 * function, set up the rays, order the cells, project them into a float image of the viewport's
 * size, blend that image into the window. Subclasses order and project.
 *
 * Honoured: the colour (RGB or gray) and scalar opacity functions, ScalarOpacityUnitDistance, the
 * scalar mode and array choice (point scalars linear, cell scalars constant in their cell; of
 * several components the colour function's VectorMode and VectorComponent choose), up to six
 * clipping planes, the volume's matrix (lengths are those of the world), viewports, perspective and
 * parallel projection, opaque geometry per pixel, the camera inside the mesh. In a hardware
 * selection pass nothing is drawn. Several volumes are drawn one after the other: where they
 * overlap, the order of their cells is not that of the depths.
 *
 * Tiles ask the window's CheckAbortStatus at the start and before every tile of the calling thread: a
 * frame that is given up leaves no trace of the volume, in the window or in the frames after it.
 *
 * A new mesh is prepared once, which takes seconds where it is large: ProgressEvents say how far that
 * is, GetProgress() goes from 0 to 1.
 *
 * What is asked for and not drawn is named by one warning, bad input by one error or warning that
 * counts the offenders; the rest is drawn. A message comes again when it changes.
 *
 * Points of the property's functions that are not finite are left out, opacities below 0 count as
 * 0; above 1 they are as opaque as they say, but for the pixel's own opacity of a maximum.
 *
 * A cell scalar exactly on a step of a function has the value that the function itself answers there
 * (GetValue, GetColor), which VTK's versions take from different sides; one within 4e-6 of the
 * distance from the low end of the range counts as on the step. Cells whose points all lie on a step
 * are drawn with one of its sides, which is not guaranteed to be VTK's, and tables are no finer than
 * their entries.
 *
 * Worlds may be from 1e-15 to 1e18 in size. Opacity is that of a length: in a world of a millionth
 * ScalarOpacityUnitDistance must be as small, or next to nothing is seen. In larger worlds Tiles leave
 * the range of a float in perspective, in smaller ones the extinction is cut off at 1e18 per world
 * length.
 *
 * Scalars are floats over the range in which the functions change: a ramp of colours over 1e-4 of that
 * range can be off by 1e-3.
 *
 * Arrays are taken as they are at Render: call Modified() on one that was written in place.
 */
class VTKCELLPROJECTION_EXPORT vtkConvexCellMapper : public vtkUnstructuredGridVolumeMapper
{
public:
  vtkTypeMacro(vtkConvexCellMapper, vtkUnstructuredGridVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// vtkVolumeMapper's numbers, of which VTK's base class for unstructured grids knows two.
  enum BlendModes
  {
    COMPOSITE = 0,
    MAXIMUM_INTENSITY = 1,
    MINIMUM_INTENSITY = 2,
    ADDITIVE = 4,
    ISOSURFACE = 5
  };

  ///@{
  /**
   * How the samples of a ray become a pixel. A mode that this mapper cannot draw is one error that
   * names the mapper that can, and changes nothing. Default: the mapper's own.
   */
  void SetBlendMode(int mode) override;
  void SetBlendModeToMinimumIntensity() { this->SetBlendMode(MINIMUM_INTENSITY); }
  void SetBlendModeToAdditive() { this->SetBlendMode(ADDITIVE); }
  void SetBlendModeToIsoSurface() { this->SetBlendMode(ISOSURFACE); }
  ///@}

  enum Engines
  {
    AUTOMATIC = 0,
    RASTER = 1,
    TILES = 2
  };

  ///@{
  /**
   * What projects: Raster is OpenGL 3.2 core, Tiles plain C++ on all cores, for any mesh without a
   * sort. Automatic takes Tiles where OpenGL is drawn in software (llvmpipe, softpipe) and Tiles
   * draws what is set; where it does not, Tiles warns once and draws by Raster. Default:
   * Automatic.
   */
  vtkSetClampMacro(Engine, int, AUTOMATIC, TILES);
  vtkGetMacro(Engine, int);
  void SetEngineToAutomatic() { this->SetEngine(AUTOMATIC); }
  void SetEngineToRaster() { this->SetEngine(RASTER); }
  void SetEngineToTiles() { this->SetEngine(TILES); }
  ///@}

  ///@{
  /**
   * Any vtkDataSet (unstructured, structured, rectilinear, image data) or composite data set. The
   * blocks are drawn as one volume with one order; those that lack the chosen array, or have it
   * with another type, are left out and named in one warning. GetInput() is null for all but
   * unstructured grids: GetDataObjectInput() gives any.
   */
  void SetInputData(vtkUnstructuredGridBase* grid) override { this->SetInputDataInternal(0, grid); }
  void SetInputData(vtkDataSet* data) override { this->SetInputDataInternal(0, data); }
  void SetInputData(vtkDataObject* data) { this->SetInputDataInternal(0, data); }
  ///@}

  using vtkUnstructuredGridVolumeMapper::GetBounds;
  double* GetBounds() VTK_SIZEHINT(6) override;

  ///@{
  /**
   * How closely curved cells are followed, see vtkConvexCells. Default: 0.001.
   */
  vtkSetClampMacro(Tolerance, double, 1e-7, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Keep the float image of the next frames, before they are blended into the window. Default: off,
   * and then it costs nothing.
   */
  vtkSetMacro(CaptureImage, bool);
  vtkGetMacro(CaptureImage, bool);
  vtkBooleanMacro(CaptureImage, bool);
  ///@}

  ///@{
  /**
   * Tiles draw coarser, down to MaximumImageSampleDistance, while the time that the renderer allots to
   * the volume (vtkRenderWindow::SetDesiredUpdateRate, which interactors set) is shorter than the last
   * frames took: as vtkUnstructuredGridVolumeRayCastMapper does. At rest, where it
   * allots more than ten seconds, every pixel has its ray. Raster is never coarser. Default: on.
   */
  vtkSetClampMacro(AutoAdjustSampleDistances, vtkTypeBool, 0, 1);
  vtkGetMacro(AutoAdjustSampleDistances, vtkTypeBool);
  vtkBooleanMacro(AutoAdjustSampleDistances, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Pixels from ray to ray in both directions: of every frame by Tiles where
   * AutoAdjustSampleDistances is off. Between the rays the image is linear; beside opaque geometry
   * rays count by how near its window depth at them is to the pixel's. Default: 1, and no less.
   */
  vtkSetClampMacro(ImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(ImageSampleDistance, float);
  ///@}

  ///@{
  /**
   * What AutoAdjustSampleDistances may choose. Defaults: 1 and 10.
   */
  vtkSetClampMacro(MinimumImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(MinimumImageSampleDistance, float);
  vtkSetClampMacro(MaximumImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(MaximumImageSampleDistance, float);
  ///@}

  /**
   * The volume alone as the last frame drew it: the viewport's size, one float array of 4
   * components, premultiplied RGBA, first row at the bottom. Null where CaptureImage was off or
   * nothing could be drawn.
   */
  vtkImageData* GetCapturedImage();

  /**
   * One row about the last frame. Columns: Method, Engine, CellsIn (of the input), CellsDrawn
   * (projected: tetrahedra where the method cuts cells up), CellsSkippedTransparent (likewise),
   * CellsSkippedInvalid (cells of the input that are no cells to draw, plus projected ones with a
   * scalar that is not finite), CellsSkippedOutside (worth drawing, but outside the viewport or behind
   * a clipping plane or opaque geometry, the near or the far plane: tetrahedra by Tiles alone, found
   * in runs, so that some cells there count as drawn),
   * Cycles (groups of cells that hide each other in a circle), MisorderedFaces (where the mapper is
   * asked to count),
   * RepairedPixels, SecondsPrepare, SecondsSort, SecondsProject (until the driver is done),
   * SecondsBlend. What a method does not have is 0. A frame of fewer rays than pixels has one more,
   * ImageSampleDistance: pixels from ray to ray.
   */
  vtkTable* GetLastStatistics();

  /// True where the window has OpenGL 3.2; whether it renders to floats shows in the first frame.
  static bool IsSupported(vtkRenderWindow* window);

  using vtkUnstructuredGridVolumeMapper::Update;
  void Update() override;

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkConvexCellMapper();
  ~vtkConvexCellMapper() override;

  /// The name in the statistics' column Method.
  virtual const char* GetMethodName() const = 0;
  virtual bool CanDrawBlendMode(int mode) const = 0;
  /// True where convex cells are to be cut into tetrahedra.
  virtual bool NeedsTetrahedra() const = 0;
  /// True where Shade and gradient opacity are drawn.
  virtual bool CanShade() const { return false; }
  /// True where dependent components are drawn.
  virtual bool CanDepend() const { return this->CanShade(); }
  /// Scalars that are not the input's, such as those of a texture; null: the input's.
  virtual vtkDataArray* GetOwnScalars() { return nullptr; }
  /// True where cells may keep what they were when their points were elsewhere (vtkConvexCells).
  virtual bool KeepsCells() const { return false; }
  /// False where ScalarOpacity is a pixel's own opacity, whatever the length of the ray.
  virtual bool IsOpacityPerLength() const { return true; }
  /// Orders the cells for this view.
  virtual void SortCells(CellProjectionFrame& frame) = 0;
  /// What keeps the Tiles engine from drawing what is set, as one says it after "does not draw";
  /// empty where nothing does.
  virtual std::string FindTilesObstacle(const CellProjectionFrame&) const
  {
    return "the cells of this mapper";
  }
  /// The Tiles engine's image: premultiplied RGBA of frame.ImageSize; null where nothing can be drawn.
  virtual const float* DrawTiles(CellProjectionFrame&) { return nullptr; }
  /// True, after SortCells, where ProjectCells draws into the window's framebuffer and its depth, and
  /// not into the float target: there is no image then. Tiles do not ask.
  virtual bool DrawsIntoWindow() const { return false; }
  /// Draws the cells into the bound float target. False where nothing can be drawn.
  virtual bool ProjectCells(CellProjectionFrame& frame) = 0;

  /// Says how far the preparation of a new mesh has come (0 to 1, subclasses begin at .5), as a
  /// ProgressEvent. Called after work that frames of the same mesh do not do again.
  void ReportPreparation(double share);

  /// What the stages before left for SortCells and ProjectCells.
  const PreparedVolume& GetPreparedVolume() const;

  ///@{
  /// One message for each different text; a warning without text is none.
  void WarnOnce(const std::string& text);
  void FailOnce(const std::string& text);
  ///@}

  /// Releases what the GPU holds, in its own window's context. Subclasses call it in their
  /// destructor.
  void LeaveWindow();
  /// Deletes what the GPU holds; that window's context is current. Subclasses delete theirs first.
  virtual void ReleaseBuffers(vtkWindow* window);

  int FillInputPortInformation(int port, vtkInformation* info) override;

  int Engine = AUTOMATIC;
  bool CaptureImage = false;
  double Tolerance = 1e-3;
  vtkTypeBool AutoAdjustSampleDistances = 1;
  float ImageSampleDistance = 1.0f;
  float MinimumImageSampleDistance = 1.0f;
  float MaximumImageSampleDistance = 10.0f;

private:
  vtkConvexCellMapper(const vtkConvexCellMapper&) = delete;
  void operator=(const vtkConvexCellMapper&) = delete;

  bool BeginFrame(vtkRenderer* renderer, vtkVolume* volume, CellProjectionFrame& frame);
  bool EnterWindow(CellProjectionFrame& frame);
  void ChooseEngine(CellProjectionFrame& frame);
  bool PrepareCells(CellProjectionFrame& frame);
  bool PrepareScalars(CellProjectionFrame& frame);
  void PrepareTransferFunction(CellProjectionFrame& frame);
  bool PrepareView(CellProjectionFrame& frame);
  void EndPreparation(CellProjectionFrame& frame);
  void ReportCells();
  bool Project(CellProjectionFrame& frame);
  bool ProjectByTiles(CellProjectionFrame& frame);
  bool FindOpaque(CellProjectionFrame& frame);
  void TakeOpaqueDepth(CellProjectionFrame& frame);
  bool LookAtWindow(CellProjectionFrame& frame);
  const float* DrawTilesAsSeen(CellProjectionFrame& frame);
  bool LayPixelsOver(CellProjectionFrame& frame);
  double ChooseImageSampleDistance(CellProjectionFrame& frame) const;
  void RecordSampling(const CellProjectionFrame& frame, bool isDrawn);
  bool ProjectIntoTarget(CellProjectionFrame& frame);
  void Blend(CellProjectionFrame& frame);
  void EndFrame(CellProjectionFrame& frame);

  bool CheckInput();
  /// False, with the problem as an error, where there is one.
  bool PassesWithout(const std::string& problem);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
