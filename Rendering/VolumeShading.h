#ifndef VolumeShading_h
#define VolumeShading_h

#include "DependentColors.h"
#include "SceneLighting.h"
#include "TransferFunction.h"
#include "VertexGradients.h"
#include "vtkTimeStamp.h"

#include <glm/mat3x3.hpp>

#include <string>
#include <vector>

struct CellProjectionFrame;
struct PreparedVolume;

/**
 * @class VolumeShading
 * @brief What lights a volume of tetrahedra, makes it transparent by its gradient, or colours it by
 * other components than its opacity.
 *
 * Where the property asks for neither, nothing is computed. Gradients are computed again when the
 * points, the cells or the scalars change; lights and coefficients are read in every frame.
 */
class VolumeShading
{
public:
  /// `corners`: 4 ids per cell, made at `cornersTime`. `problem` names what cannot shine.
  void Prepare(const CellProjectionFrame& frame, const PreparedVolume& prepared,
    const std::vector<int>& corners, const vtkTimeStamp& cornersTime, std::string& problem);

  bool IsNeeded() const
  {
    return this->IsLit || this->HasGradientOpacity || this->Colors.Kind != DependentColors::None;
  }

  /// Where gradients are needed; null: at all points. Must outlive Prepare.
  void SetWantedPoints(const std::vector<int>* points)
  {
    this->WantedPoints = points;
    this->WantedTime.Modified();
  }

  /// Off for those who draw one component alone: Colors stays None.
  bool TakesColors = true;
  bool IsLit = false;
  bool HasGradientOpacity = false;
  DependentColors Colors;
  VertexGradients Gradients;
  SceneLighting Lighting;
  /// By the length of the gradient, normalised.
  TransferFunction GradientOpacity;
  /// From mesh to view coordinates, but for a factor; GradientScale takes the length of the result
  /// to the normalised length of the gradient of the scalar in the world.
  glm::mat3 GradientToView{ 1.0f };
  float GradientScale = 1.0f;

  /// When each was made; what was made from it before is out of date.
  vtkTimeStamp GradientsTime;
  vtkTimeStamp OpacityTime;

private:
  void PrepareGradients(const PreparedVolume& prepared, const std::vector<int>& corners,
    const vtkTimeStamp& cornersTime);
  void SetMatrix(const CellProjectionFrame& frame, const PreparedVolume& prepared);

  vtkTimeStamp LinksTime;
  const std::vector<int>* WantedPoints = nullptr;
  vtkTimeStamp WantedTime;
  vtkTimeStamp WantedLinksTime;
  double GreatestGradient = 1.0;
};

#endif
