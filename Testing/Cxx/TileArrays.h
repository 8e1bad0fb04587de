#ifndef TileArrays_h
#define TileArrays_h

#include "TilesEngine.h"
#include "TransferFunction.h"

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

/// The Tiles engine with plain arrays: no window, no VTK data.
class TileArrays
{
public:
  /// A shaken lattice of 6 n^3 tetrahedra in [-1, 1]^3.
  explicit TileArrays(int n);

  /// Three points, or nine with spikes between which nothing is seen.
  void SetFunction(bool spiky, double unitDistance = 0.2);
  /// The same colours; linear between the nodes.
  void SetOpacity(const std::vector<double>& nodes, const std::function<double(double)>& opacity,
    double unitDistance);
  /// Hands points, corners and scalars to the engine.
  void SetMesh();
  /// From `eye` to the middle.
  void LookFrom(const glm::dvec3& eye, double angle, int width, int height);
  /// The largest difference of two images' numbers; 1e30 where they are not of one size.
  static double LargestDifference(const std::vector<float>& a, const std::vector<float>& b);
  bool Render() { return this->Engine.Render(this->Scene); }

  int GetNumberOfCells() const { return static_cast<int>(this->Corners.size() / 4); }

  /// x, y, z and an unused fourth.
  std::vector<float> Points;
  std::vector<float> Scalars;
  std::vector<int> Corners;
  TilesEngine Engine;
  TilesEngine::Scene Scene;

private:
  void AddCell(const int (&corner)[3], const int (&axes)[3], int side);

  TransferFunction Function;
};

#endif
