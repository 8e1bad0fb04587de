#ifndef TestScene_h
#define TestScene_h

#include "vtkCamera.h"
#include "vtkCellProjectionOracle.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkConvexCellMapper.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPreIntegratedTetrahedraMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <iostream>
#include <string>
#include <vector>

/// Fails the test with the place and what was found; `return checks.Result();` ends it.
class TestChecks
{
public:
  void Check(bool good, const char* text, int line, const std::string& found = "");
  int Result() const { return this->Failures == 0 ? 0 : 1; }

private:
  int Failures = 0;
};

#define CHECK(condition) checks.Check((condition), #condition, __LINE__)
#define CHECK_AT_MOST(value, bound) \
  checks.Check((value) <= (bound), #value " <= " #bound, __LINE__, std::to_string(value))
#define CHECK_NEAR(value, expected, bound)                                                   \
  checks.Check(std::abs((value) - (expected)) <= (bound), #value " is " #expected, __LINE__, \
    std::to_string(value) + ", not " + std::to_string(expected))

/// Collects what an object says instead of printing it (an "ERROR:" in the output fails a test).
class MessageObserver : public vtkCommand
{
public:
  static MessageObserver* New() { return new MessageObserver; }
  void Execute(vtkObject* caller, unsigned long event, void* data) override;
  void Watch(vtkObject* object);
  int Count() const { return static_cast<int>(this->Texts.size()); }
  /// How many of the messages contain `text`.
  int CountOf(const std::string& text) const;

  std::vector<std::string> Texts;
};

/// A window of one of our mappers with the oracle beside it.
class TestScene
{
public:
  /// With a vtkPreIntegratedTetrahedraMapper and a sort that is right for every mesh.
  /// The engine is that of CELLPROJECTION_TEST_ENGINE, Raster or Tiles, where that is set.
  explicit TestScene(int width = 128, int height = 128);
  explicit TestScene(vtkConvexCellMapper* mapper, int width = 128, int height = 128);
  /// Lets CELLPROJECTION_TEST_ENGINE choose the mapper's engine.
  void TakeTestEngine();
  virtual ~TestScene() = default;

  /// The largest difference between the captured image and the oracle; below zero where either
  /// failed. Prints all the figures.
  double MaximumError(const std::string& name);
  /// Draws the oracle's image of the scene as it is, in the mapper's blend mode.
  bool UpdateOracle();
  void Render();
  /// Premultiplied RGBA of a pixel of the captured image.
  std::array<double, 4> Pixel(int x, int y);
  std::array<double, 4> CenterPixel();
  /// The largest difference between two captured images; below zero where their sizes differ.
  static double Difference(vtkImageData* a, vtkImageData* b);
  /// How many pixels of two images of one size differ by more than `bound` in a component.
  static int CountDifferent(vtkImageData* a, vtkImageData* b, double bound);
  /// A copy of the image captured last.
  vtkSmartPointer<vtkImageData> CopyCaptured();
  void SetGrid(vtkUnstructuredGrid* grid);
  /// Any cells: the oracle sees the tetrahedra that are drawn.
  virtual void SetMesh(vtkUnstructuredGrid* grid);
  /// Beside the first, each in its half of the window, with the same volume and camera.
  vtkSmartPointer<vtkRenderer> AddSecondViewport();
  /// Of the last frame.
  vtkIdType GetStatistic(const char* column);
  /// Of `cells` all are drawn or left out for a reason: none as outside in a view of `wide` degrees, some in one of 5.
  void CheckCellsLeftOut(TestChecks& checks, double wide, vtkIdType cells);
  /// Constant colour and extinction (per unit distance 1).
  void SetConstant(double opacity);
  /// Nine points with spikes; `smooth` has three.
  void SetSpiky();
  void SetSmooth();
  /// The smooth function of the report over the scalars of `grid`: opacity that rises to 1 over a
  /// twentieth of its diagonal.
  void SetReportSmooth(vtkUnstructuredGrid* grid);
  void LookFrom(double x, double y, double z);
  /// The mapper where it is that of tetrahedra, else null.
  vtkPreIntegratedTetrahedraMapper* GetTetrahedraMapper();

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkSmartPointer<vtkConvexCellMapper> Mapper;
  vtkNew<vtkCellProjectionOracle> Oracle;
};

#endif
