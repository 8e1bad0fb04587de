/**
 * @class   vtkCellProjectionOracle
 * @brief   float64 ray caster that the mappers are measured against
 *
 * Draws an unstructured grid as DESIGN's optical model says, slowly and obviously: for every pixel
 * centre and every cell the ray is clipped against the cell, the segments are sorted by depth, and
 * the emission and absorption of each is integrated adaptively to about 1e-10. It shares no code
 * with the mappers, needs no window, and everything is double.
 *
 *     input    vtkUnstructuredGrid; tetrahedra (scalar linear) and any other convex linear cells
 *              (faces cut from the smallest point id, scalar linear on each triangle and between a
 *              ray's entry and exit). Ignored: 2-D and lower cells, non-linear cells and convex
 * point sets, duplicate and hidden (ghost) cells, cells of zero volume or with a non-finite value
 *     scalars  component 0 of the point array (default) or, constant per cell, of the cell array;
 *              with IndependentComponents off the last of two or four (value and opacity, RGBA)
 *     volume   its property's colour, opacity, gradient opacity, unit distance and lighting
 *              (component 0), its matrix; gradients are those at the points, volume-weighted from
 *              the tetrahedra around them, linear in between; composite alone is lit
 *     image    width x height, double, 4 components: premultiplied RGBA, first row at the bottom,
 *              before any blending into a background
 *
 * Lengths are world lengths along the ray, after the volume's matrix. The near and far planes of
 * the camera's clipping range, the clipping planes and the opaque depth cut the rays.
 *
 * Errors: no input, volume or camera, a size below 1, an unknown blend mode, a missing array, a
 * unit distance that is not positive, a matrix without an inverse, a depth array of the wrong
 * length, and shading, gradient opacity or dependent components of other cells than tetrahedra give
 * one vtkErrorMacro, and Update() returns false and leaves no image.
 *
 * Not guaranteed: cells that overlap are drawn one after the other by the middles of their
 * segments; non-convex polyhedra are drawn as their outermost intersections; nothing is updated
 * unless Update() is called.
 */

#ifndef vtkCellProjectionOracle_h
#define vtkCellProjectionOracle_h

#include "vtkCellProjectionOracleModule.h" // for export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for the inputs

#include <memory> // for std::unique_ptr
#include <string> // for ArrayName
#include <vector> // for Segments

class OracleCamera;
class OracleCells;
class OracleIntegrator;
class OracleStatistics;
enum class OracleColors;
class vtkCamera;
class vtkDataArray;
class vtkImageData;
class vtkLightCollection;
class vtkPlaneCollection;
class vtkUnstructuredGrid;
class vtkVolume;

class VTKCELLPROJECTIONORACLE_EXPORT vtkCellProjectionOracle : public vtkObject
{
public:
  static vtkCellProjectionOracle* New();
  vtkTypeMacro(vtkCellProjectionOracle, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** vtkVolumeMapper's numbers. */
  enum BlendModes
  {
    COMPOSITE_BLEND = 0,
    MAXIMUM_INTENSITY_BLEND = 1,
    MINIMUM_INTENSITY_BLEND = 2,
    ADDITIVE_BLEND = 4
  };

  ///@{
  /** What is drawn, as what and from where. Default: null. */
  void SetInputData(vtkUnstructuredGrid* grid);
  void SetVolume(vtkVolume* volume);
  void SetCamera(vtkCamera* camera);
  ///@}

  /** The image's size in pixels; pixels are square. Default: 0 x 0. */
  void SetSize(int width, int height);

  ///@{
  /** One of BlendModes. Default: composite. */
  void SetBlendMode(int mode);
  vtkGetMacro(BlendMode, int);
  ///@}

  /** The array of the scalars; null or empty, the default, is the active one. */
  void SetArrayName(const char* name);

  ///@{
  /** Whether the scalars are cell data, constant in a cell. Default: off, point data. */
  void SetCellScalars(bool cellScalars);
  vtkGetMacro(CellScalars, bool);
  ///@}

  /**
   * What lights the volume where its property's Shade is on; a directional light whose focal point is
   * its position is left out. Null is a white headlight. Default: null.
   */
  void SetLights(vtkLightCollection* lights);

  /** World planes; the side where a plane's function is not negative is kept. Default: null. */
  void SetClippingPlanes(vtkPlaneCollection* planes);

  /**
   * The z-buffer: width x height window depths in [0, 1], bottom row first, 1 where nothing is.
   * Rays end there. Default: null.
   */
  void SetOpaqueDepth(vtkDataArray* depths);

  /** Draws the image; false, after one error, if it cannot. */
  bool Update();

  /** The last Update()'s image; null before the first and after a failed one. */
  vtkImageData* GetImage();

  /** How many pieces of rays inside cells the last Update() found in all pixels. */
  vtkIdType GetNumberOfSegments();

  /**
   * Compares an image of the same size and 4 components with the last Update()'s. An error (no
   * image, other size) leaves infinite errors over no pixels, so no bound is met by accident.
   */
  void Compare(vtkImageData* captured);

  ///@{
  /**
   * What the last Compare() found, over the pixels that either image covers: the oracle has a
   * segment there, or the other image is not zero. The error of a pixel is the largest absolute
   * difference over RGBA; the percentile is the 99.9th, the half level 1/510. Infinite before the
   * first.
   */
  vtkGetMacro(RootMeanSquareError, double);
  vtkGetMacro(PercentileError, double);
  vtkGetMacro(MaximumError, double);
  vtkGetMacro(ShareAboveHalfLevel, double);
  vtkGetMacro(NumberOfCoveredPixels, vtkIdType);
  ///@}

  /** Column and row of the (first) largest error; -1 where there is none. */
  void GetMaximumErrorPixel(int pixel[2]);

protected:
  vtkCellProjectionOracle();
  ~vtkCellProjectionOracle() override;

private:
  vtkCellProjectionOracle(const vtkCellProjectionOracle&) = delete;
  void operator=(const vtkCellProjectionOracle&) = delete;

  bool CheckInputs();
  bool CheckNumbers();
  vtkDataArray* FindScalars();
  bool NeedsGradients();
  bool CreateCamera(const double center[3], std::unique_ptr<OracleCamera>& camera);
  void Draw(const OracleCamera& camera, const OracleCells& cells, OracleColors colors);
  void DrawRow(int row, const OracleCamera& camera, const OracleCells& cells,
    const OracleIntegrator& integrator, double* pixels);
  bool CheckCaptured(vtkImageData* captured);
  void CollectStatistics(const OracleStatistics& statistics);
  void ForgetComparison();

  vtkSmartPointer<vtkUnstructuredGrid> InputData;
  vtkSmartPointer<vtkVolume> Volume;
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkLightCollection> Lights;
  vtkSmartPointer<vtkPlaneCollection> ClippingPlanes;
  vtkSmartPointer<vtkDataArray> OpaqueDepth;
  vtkSmartPointer<vtkImageData> Image;
  std::string ArrayName;
  std::vector<vtkIdType> Segments; // per pixel
  int Size[2] = { 0, 0 };
  int BlendMode = COMPOSITE_BLEND;
  bool CellScalars = false;
  double RootMeanSquareError;
  double PercentileError;
  double MaximumError;
  double ShareAboveHalfLevel;
  vtkIdType NumberOfCoveredPixels;
  int MaximumErrorPixel[2];
};

#endif
