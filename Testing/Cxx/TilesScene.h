#ifndef TilesScene_h
#define TilesScene_h

#include "MeshCoordinates.h"
#include "ScalarField.h"
#include "TestScene.h"
#include "TetrahedraSelection.h"
#include "TilesEngine.h"
#include "TransferFunction.h"

#include <array>
#include <string>
#include <vector>

/// A scene that is never rendered in a window: its camera, property and oracle serve the Tiles
/// engine alone.
class TilesScene : public TestScene
{
public:
  explicit TilesScene(int width = 128, int height = 128);

  /// Tetrahedra; takes their active point scalars, or with `cellScalars` those of the cells.
  void SetTetrahedra(vtkUnstructuredGrid* grid, bool cellScalars = false);

  /// At the middle of a mesh, along a direction from it, `distance` times its length away.
  void LookAt(vtkUnstructuredGrid* grid, const double (&direction)[3], double distance);

  /// Draws by the engine; false where it refused.
  bool DrawTiles();
  /// What the engine took of it, without what its input took.
  double SecondsOfEngine = 0.0;
  /// The largest difference between the engine's image and the oracle; below zero where either
  /// failed. Prints all the figures.
  double TilesError(const std::string& name);
  /// The engine's image.
  vtkSmartPointer<vtkImageData> CopyTiles() const;

  TilesEngine Engine;
  std::vector<vtkIdType> BackToFront;
  std::vector<float> OpaqueDepth;
  bool CellScalars = false;
  bool EndsEarly = true;
  bool TimesStages = false;
  bool TrustsOrder = true;
  TileLoop::AbortCheck IsAborted;

private:
  TilesEngine::Scene DescribeScene();

  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  MeshCoordinates Coordinates;
  TetrahedraSelection Selection;
  ScalarField Field;
  TransferFunction Function;
  int Size[2];
};

#endif
