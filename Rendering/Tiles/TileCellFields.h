/**
 * Functions that are linear inside each tetrahedron of a mesh: the gradient, other components.
 *
 * Three per cell, each of the point's place: V[0] x + V[1] y + V[2] z + V[3] in mesh coordinates. A
 * cell too thin for floats has the mean of its corners everywhere.
 */
#ifndef TileCellFields_h
#define TileCellFields_h

#include <cstddef>
#include <vector>

class TileMesh;

class TileCellFields
{
public:
  /** `values`: 4 floats (the last unused) per point, or per cell, of what the mesh was built from.
   *  Uses all threads; the result does not depend on their number. */
  void Build(const TileMesh& mesh, const std::vector<float>& values, bool onePerCell);
  void Clear() { this->Values.clear(); }
  std::size_t GetMemorySize() const { return sizeof(float) * this->Values.size(); }

  static constexpr int Functions = 3;
  static constexpr int Stride = 4 * Functions;
  std::vector<float> Values;

private:
  void BuildCell(const TileMesh& mesh, const std::vector<float>& values, int cell);
};

#endif
