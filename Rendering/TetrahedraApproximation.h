#ifndef TetrahedraApproximation_h
#define TetrahedraApproximation_h

#include "ApproximationRaster.h"
#include "CellApproximation.h"
#include "CellShapes.h"
#include "ProjectedPoints.h"
#include "vtkTimeStamp.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <memory>
#include <string>
#include <vector>

class TetrahedraSelection;
struct CellProjectionFrame;
struct PreparedVolume;

/// The numbers are those of vtkPreIntegratedTetrahedraMapper's Approximation.
enum class ApproximationKind
{
  None,
  ShirleyTuchman,
  ShirleyTuchmanExponential,
  Voxel,
  UniformThickness1,
  UniformThickness2,
  Centroid
};

/**
 * @class TetrahedraApproximation
 * @brief Tetrahedra drawn as the triangles of one of the approximations of the literature.
 *
 * The values of points and the shapes of cells are kept until what they are made of changes.
 */
class TetrahedraApproximation
{
public:
  struct Settings
  {
    ApproximationKind Kind = ApproximationKind::None;
    /// Of Centroid: thickness over radius, and the rim's share of the opacity.
    double CentroidThickness = 0.0;
    double CentroidRimOpacity = 0.0;
  };

  /// What does not depend on the eye. `frame` gives the volume's matrix.
  void Prepare(const Settings& settings, const PreparedVolume& prepared,
    const TetrahedraSelection& selection, const CellProjectionFrame& frame);

  /// `order`: cells from back to front. False, with the reason in GetFailure, where it cannot.
  bool Draw(const PreparedVolume& prepared, const TetrahedraSelection& selection,
    const std::vector<unsigned int>& order, CellProjectionFrame& frame);

  void ReleaseGraphicsResources() { this->Raster.ReleaseGraphicsResources(); }
  const std::string& GetFailure() const { return this->Raster.GetFailure(); }

private:
  void PrepareShapes(const PreparedVolume& prepared, const TetrahedraSelection& selection);
  std::unique_ptr<CellApproximation> Make(const Settings& settings) const;
  void ClassifyPoints(const PreparedVolume& prepared);
  void ClassifyCenters(const PreparedVolume& prepared, const TetrahedraSelection& selection);

  ApproximationKind Kind = ApproximationKind::None;
  std::unique_ptr<CellApproximation> Approximation;
  glm::dmat4 MeshToWorld{ 0.0 };
  ProjectedPoints Points;
  CellShapes Shapes;
  /// One per point or per cell.
  std::vector<glm::vec4> Values;
  std::vector<glm::vec4> CenterValues;
  ApproximationRaster Raster;

  vtkTimeStamp ShapesTime;
  vtkTimeStamp ValuesTime;
};

#endif
