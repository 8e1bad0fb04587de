#ifndef ApproximationTriangles_h
#define ApproximationTriangles_h

#include "ProjectedTetrahedron.h"

#include <glm/vec4.hpp>

#include <array>
#include <vector>

/**
 * @class ApproximationTriangles
 * @brief The triangles on the screen that stand for cells, in the order in which they are drawn.
 *
 * All that a vertex has is interpolated linearly on the screen.
 */
class ApproximationTriangles
{
public:
  /// Screen in normalised device coordinates; the depth where the cell begins there, and from there
  /// to where it ends; colour, and the opacity or extinction that the approximation's fragments
  /// take.
  struct Vertex
  {
    glm::vec2 Screen;
    float Front;
    float Thickness;
    glm::vec4 Value;
  };
  using Rim = std::array<Vertex, 4>;

  static Vertex MakeVertex(
    const glm::dvec2& screen, double front, double thickness, const glm::vec4& value)
  {
    return { glm::vec2(screen), static_cast<float>(front), static_cast<float>(thickness), value };
  }

  /// The cell's corners, where it is as thin as its edges, all of this opacity or extinction.
  static Rim MakeRim(const ProjectedTetrahedron& cell, float opacity);

  /// The triangles between an inner point and the silhouette.
  void AppendFan(const ProjectedTetrahedron& cell, const Vertex& middle, const Rim& rim);

  /// The faces that look to the eye, or those that do not.
  void AppendFaces(const ProjectedTetrahedron& cell, const Rim& corners, bool areFront);

  std::vector<Vertex> Vertices;
  /// Three per triangle.
  std::vector<unsigned int> Indices;

private:
  unsigned int AppendVertices(const Rim& rim);
};

#endif
