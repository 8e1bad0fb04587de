#include "VolumeShading.h"

#include "CellProjectionFrame.h"
#include "LightReader.h"
#include "PreparedVolume.h"
#include "SceneView.h"
#include "VolumePropertyReader.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void VolumeShading::Prepare(const CellProjectionFrame& frame, const PreparedVolume& prepared,
  const std::vector<int>& corners, const vtkTimeStamp& cornersTime, std::string& problem)
{
  vtkVolumeProperty* property = frame.Volume->GetProperty();
  VolumePropertyReader reader(property);
  this->IsLit = property->GetShade() != 0;
  this->HasGradientOpacity = reader.HasGradientOpacity();
  if (this->TakesColors)
  {
    this->Colors.Prepare(prepared, reader);
  }
  if (!this->IsNeeded())
  {
    return;
  }
  this->PrepareGradients(prepared, corners, cornersTime);
  if (this->HasGradientOpacity)
  {
    this->GreatestGradient = reader.ReadGradientOpacity(this->GradientOpacity);
    this->OpacityTime.Modified();
  }
  if (this->IsLit)
  {
    const LightReader lights(SceneView::GetWorldToView(frame));
    this->Lighting = lights.Read(frame.Renderer->GetLights(), property, problem);
  }
  this->SetMatrix(frame, prepared);
}

//------------------------------------------------------------------------------
void VolumeShading::PrepareGradients(const PreparedVolume& prepared,
  const std::vector<int>& corners, const vtkTimeStamp& cornersTime)
{
  const std::vector<float>& points = prepared.Coordinates.Points;
  if (this->LinksTime < cornersTime)
  {
    this->Gradients.SetCells(corners, points.size() / 4);
    this->LinksTime.Modified();
  }
  if (this->WantedPoints && this->WantedLinksTime < std::max(this->WantedTime, this->LinksTime))
  {
    this->Gradients.SetWanted(*this->WantedPoints);
    this->WantedLinksTime.Modified();
  }
  if (this->GradientsTime < this->LinksTime || this->GradientsTime < prepared.PointsTime ||
      this->GradientsTime < prepared.ScalarsTime || this->GradientsTime < this->WantedTime)
  {
    if (prepared.Scalars.OnePerCell)
    {
      this->Gradients.BuildZero();
    }
    else if (this->WantedPoints)
    {
      this->Gradients.BuildAt(points, corners, prepared.Scalars.Values);
    }
    else
    {
      this->Gradients.Build(points, corners, prepared.Scalars.Values);
    }
    this->GradientsTime.Modified();
  }
}

//------------------------------------------------------------------------------
void VolumeShading::SetMatrix(const CellProjectionFrame& frame, const PreparedVolume& prepared)
{
  // A gradient is a row vector: it is carried by the inverse of what carries points.
  const glm::dmat3 matrix = glm::transpose(glm::inverse(glm::dmat3(frame.Rays.MeshToView)));
  double greatest = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    greatest = std::max(greatest, std::abs(matrix[i / 3][i % 3]));
  }
  this->GradientToView = glm::mat3(matrix / greatest);
  const double width = prepared.Scalars.Normal[1] - prepared.Scalars.Normal[0];
  this->GradientScale = static_cast<float>(greatest * width / this->GreatestGradient);
}
