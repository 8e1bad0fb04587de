#ifndef CellShapes_h
#define CellShapes_h

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

/**
 * @class CellShapes
 * @brief What is known of tetrahedra before any eye: the spheres inscribed in them, their mean
 * chord.
 *
 * The centre of the inscribed sphere is the mean of the corners weighted by the areas of the faces
 * opposite them, its radius three volumes over the cell's area: the solution of Cignoni et al.
 * 1995, equation 1. Areas and radii are those of the world.
 */
class CellShapes
{
public:
  struct Sphere
  {
    /// Of the corners, adding up to 1: whatever is linear in space has at the centre this mean.
    glm::vec4 Weights{ 0.25f };
    float Radius = 0.0f;
  };
  /// Mesh coordinates.
  using Corners = std::array<glm::dvec3, 4>;

  static Sphere InscribedSphere(const Corners& corners, const glm::dmat4& meshToWorld);

  /// `points`: 4 floats each, `corners`: 4 ids per cell.
  void Build(const std::vector<float>& points, const std::vector<int>& corners,
    const glm::dmat4& meshToWorld);

  const Sphere& GetSphere(int cell) const { return this->Spheres[cell]; }
  /// Of all cells, over all lines that meet them: four times their volume over their area.
  double GetMeanChord() const { return this->MeanChord; }

private:
  std::vector<Sphere> Spheres;
  double MeanChord = 0.0;
};

#endif
