#ifndef ReportScene_h
#define ReportScene_h

#include "CellComplex.h"
#include "ReportMeshes.h"
#include "ReportLevels.h"
#include "ReportMethods.h"
#include "ReportRow.h"
#include "ReportViews.h"

#include "vtkSmartPointer.h"

#include <set>
#include <string>

class BenchmarkScene;
class vtkImageData;
class vtkUnstructuredGrid;
class vtkUnstructuredGridVolumeMapper;
class vtkVisibilitySort;

/// One mesh under one transfer function and light: what each method takes for it and gets wrong.
class ReportScene
{
public:
  struct Settings
  {
    int Frames = 9;
    int ImageSize = 256;
    // The oracle visits every cell for every pixel: a small picture of each view will do.
    int ErrorSize = 48;
    // VTK's ray casters may be out of time after this many: a frame of ZSweep may take minutes.
    int LeastFrames = 2;
    // A method with a longer frame is given up on the mesh.
    double SecondsPerFrame = 10.0;
  };

  ReportScene(const ReportMeshes::Mesh& mesh, const Settings& settings);

  /// "smooth" or "spiky"; "unlit" or "lit".
  void SetLook(const std::string& transfer, const std::string& light);

  /// False where the method does not draw this light or engine here, or is given up, which one line
  /// says. Frames of VTK's ray casters that begin after `seconds` are left out.
  bool Measure(const ReportMethods::Method& method, double seconds, ReportRow& row);

private:
  using Mapper = vtkSmartPointer<vtkUnstructuredGridVolumeMapper>;
  bool GiveUp(const ReportMethods::Method& method);
  vtkUnstructuredGrid* GetInput(const ReportMethods::Method& method);
  void SetProperty(BenchmarkScene& scene);
  bool MeasureError(const ReportMethods::Method& method, ReportRow& row);
  bool MeasureSpeed(const ReportMethods::Method& method, double seconds, ReportRow& row);
  bool IsDrawn(const ReportMethods::Method& method, vtkUnstructuredGridVolumeMapper* mapper,
    const std::string& warnings);
  void CompareView(int view, const ReportMethods::Method& method,
    vtkUnstructuredGridVolumeMapper* mapper, BenchmarkScene& scene, ReportRow& row);
  long long CountMisordered(const ReportMethods::Method& method,
    vtkUnstructuredGridVolumeMapper* mapper, BenchmarkScene& scene);
  long long CountMisordered(vtkVisibilitySort* sort, BenchmarkScene& scene);
  void CompareWithShirleyTuchman(
    const ReportMethods::Method& method, vtkImageData* image, ReportRow& row);

  Settings With;
  std::string Name;
  std::string Transfer;
  std::string Light;
  vtkSmartPointer<vtkUnstructuredGrid> Whole;
  vtkSmartPointer<vtkUnstructuredGrid> Convex;
  vtkSmartPointer<vtkUnstructuredGrid> Tetrahedra;
  CellComplex Complex;
  ReportViews Views;
  ReportLevels Levels;
  vtkSmartPointer<vtkImageData> ShirleyTuchman;
  double Reference = 0.0;
  /// Curves.
  std::set<std::string> GivenUp;
};

#endif
