#ifndef PolyhedraScene_h
#define PolyhedraScene_h

#include "TestScene.h"

#include <functional>
#include <string>
#include <vector>

/// The mappers that draw convex cells as they are, each way they have.
namespace PolyhedraMappers
{
struct Entry
{
  std::string Name;
  std::function<vtkSmartPointer<vtkConvexCellMapper>()> Make;
  /// The paper's way, whose error is that of the trapezoid rule.
  bool ThreePasses;
};

/// One pass, three passes, maximum, minimum.
const std::vector<Entry>& All();
/// Without three passes.
std::vector<Entry> Exact();
}

/// A scene of one of them. The oracle sees the convex cells that the mapper draws.
class PolyhedraScene : public TestScene
{
public:
  explicit PolyhedraScene(vtkConvexCellMapper* mapper, int width = 128, int height = 128);

  /// Fits the mapper's blend mode: the scalar itself in red and 1 - scalar in blue for an extremum,
  /// smooth colours and extinctions for sums.
  void SetFunctions();
  /// One colour and an extinction that is linear in the scalar: so is the emission.
  void SetLinearEmission();
  void SetMesh(vtkUnstructuredGrid* grid) override;
  bool IsAdditive() const;

  /// Pixels of the captured image that are not 0.
  int CountLitPixels();

  /// Views of a mesh in the unit cube: 0 and 1 from outside (1 parallel), 2 from within.
  static constexpr int NumberOfViews = 3;
  void SetView(int view);

  struct Errors
  {
    double Compared = -1.0; ///< Largest over RGBA; below zero where anything failed.
    double NearSilhouettes = 0.0;
    int CoveredPixels = 0;
    int SilhouettePixels = 0;
    int WrongPixels = 0; ///< Compared ones whose error is above the bound.
    double LargestValue = 0.0;
  };
  /**
   * Renders, then compares with the oracle, apart in the pixels within 1/64 pixel of a silhouette:
   * those where the oracle's rays that far to either side do not all meet the mesh, or an extremum
   * jumps; they are looked for where some pixel is off by more than the bound. Prints all the figures.
   */
  Errors CompareWithOracle(const std::string& name);

  /// What an exact mapper promises: 1e-4 for sums of about 1, 1e-5 for an extremum's scalar.
  double GetBound() const;
  /// CompareWithOracle within that bound, and at most 1 covered pixel of 40 near a silhouette.
  void CheckWithOracle(TestChecks& checks, const std::string& name, int line);
  /// The same for three passes, but for two pixels of a thousand: a triangle that the rasteriser
  /// sees edge-on, and the dents of warped faces, count the emission of a cell once more.
  void CheckMostPixels(TestChecks& checks, const std::string& name, int line);

private:
  std::vector<vtkSmartPointer<vtkImageData>> ImagesBeside();
};

#endif
