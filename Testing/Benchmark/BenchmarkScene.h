#ifndef BenchmarkScene_h
#define BenchmarkScene_h

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkUnstructuredGrid;
class vtkUnstructuredGridVolumeMapper;

/// A mesh with a scalar, and where it came from.
struct BenchmarkMesh
{
  std::string Name;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
};

/// NASA's Blunt Fin (density) where `folder` has it, else a generated curvilinear mesh: hexahedra.
BenchmarkMesh LoadBenchmarkHexahedra(const std::string& folder);
/// The same cut into tetrahedra.
BenchmarkMesh LoadBenchmarkMesh(const std::string& folder);
/// Bucky ball's voxels; null where `folder` does not have it.
vtkSmartPointer<vtkUnstructuredGrid> ReadBuckyBall(const std::string& folder);
vtkSmartPointer<vtkUnstructuredGrid> CutToTetrahedra(vtkUnstructuredGrid* grid);

/// A window that shows one volume through one mapper on black; a new eye for every frame.
class BenchmarkScene
{
public:
  /// `spiky`: opacity in three narrow spikes, not everywhere.
  BenchmarkScene(vtkUnstructuredGridVolumeMapper* mapper, vtkUnstructuredGrid* grid, int size,
    bool spiky = false);

  /// Colour, opacity and unit distance for the range and size of `grid`, as the constructor does.
  void SetFunctionsFor(vtkUnstructuredGrid* grid, bool spiky = false);

  /// The eye moves with `frame`; all of the scene comes into view, which brings pipelines up to date.
  void MoveEye(int frame);
  /// Renders until the driver is done and returns the seconds.
  double TimeRender();
  double TimeFrame(int frame);
  /// The window's colours (8 bits) as RGBA over black, alpha 0.
  vtkSmartPointer<vtkImageData> ReadWindow();

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
};

double Median(std::vector<double> values);

#endif
