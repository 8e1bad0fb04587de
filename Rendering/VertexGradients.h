#ifndef VertexGradients_h
#define VertexGradients_h

#include <cstddef>
#include <vector>

/**
 * @class VertexGradients
 * @brief The gradient of the scalar at every point of a mesh of tetrahedra.
 *
 * A point has the mean of the gradients of the tetrahedra around it, weighted by their volumes;
 * linear inside a cell, that is continuous across faces. Flat cells and cells with a scalar that is
 * not finite have no part in it; where all scalars around a point are equal it is exactly zero.
 *
 * Array shapes: points 4 floats each (xyz, one unused), corners 4 ids per cell, scalars one per
 * point; the result 4 floats per point (xyz, one unused).
 */
class VertexGradients
{
public:
  /// Which cells lie around each point; needed again only for other cells.
  void SetCells(const std::vector<int>& corners, std::size_t numberOfPoints);

  /// Uses all threads; the result does not depend on their number.
  void Build(const std::vector<float>& points, const std::vector<int>& corners,
    const std::vector<float>& scalars);

  /// The points that BuildAt is for; needed again after SetCells.
  void SetWanted(const std::vector<int>& wanted);

  /// At the wanted points alone; the others keep what they have.
  void BuildAt(const std::vector<float>& points, const std::vector<int>& corners,
    const std::vector<float>& scalars);

  /// Zero everywhere: what scalars that are constant in their cells have inside.
  void BuildZero();

  std::vector<float> Values;

private:
  /// A cell's gradient times six times its volume, and that volume.
  struct Share
  {
    double Gradient[3];
    double Volume;
  };
  static Share ShareOf(const std::vector<float>& points, const int* corners, const float* scalars);
  /// The mean of these shares for the point.
  void Gather(std::size_t point, const int* begin, const int* end, const Share* shares);

  // The cells around point i: Cells[First[i]] up to Cells[First[i + 1]].
  std::vector<std::size_t> First;
  std::vector<int> Cells;

  // The cells around any wanted point, each once; around wanted point i the ones at WantedLinks,
  // which is as First has it.
  std::vector<int> WantedPoints;
  std::vector<int> WantedCells;
  std::vector<std::size_t> WantedFirst;
  std::vector<int> WantedLinks;
  std::vector<Share> WantedShares;
};

#endif
