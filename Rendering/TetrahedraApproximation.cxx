#include "TetrahedraApproximation.h"

#include "ApproximatedCells.h"
#include "CellProjectionFrame.h"
#include "CentroidApproximation.h"
#include "ExponentialApproximation.h"
#include "PreparedVolume.h"
#include "ShirleyTuchmanApproximation.h"
#include "TetrahedraSelection.h"
#include "UniformThicknessApproximation.h"
#include "VoxelApproximation.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
bool NeedsShapes(ApproximationKind kind)
{
  return kind != ApproximationKind::ShirleyTuchman &&
         kind != ApproximationKind::ShirleyTuchmanExponential;
}
}

//------------------------------------------------------------------------------
std::unique_ptr<CellApproximation> TetrahedraApproximation::Make(const Settings& settings) const
{
  const double chord = this->Shapes.GetMeanChord();
  switch (settings.Kind)
  {
    case ApproximationKind::ShirleyTuchmanExponential:
      return std::make_unique<ExponentialApproximation>();
    case ApproximationKind::Voxel:
      return std::make_unique<VoxelApproximation>(chord);
    case ApproximationKind::UniformThickness1:
      return std::make_unique<UniformThicknessApproximation>(chord, false);
    case ApproximationKind::UniformThickness2:
      return std::make_unique<UniformThicknessApproximation>(chord, true);
    case ApproximationKind::Centroid:
      return std::make_unique<CentroidApproximation>(
        CentroidApproximation::Input{
          this->Points, this->Shapes, this->CenterValues, this->MeshToWorld },
        CentroidApproximation::Factors{
          settings.CentroidThickness, settings.CentroidRimOpacity });
    default:
      return std::make_unique<ShirleyTuchmanApproximation>(this->Points);
  }
}

//------------------------------------------------------------------------------
void TetrahedraApproximation::PrepareShapes(
  const PreparedVolume& prepared, const TetrahedraSelection& selection)
{
  this->Shapes.Build(prepared.Coordinates.Points, selection.Corners, this->MeshToWorld);
  this->ShapesTime.Modified();
}

//------------------------------------------------------------------------------
void TetrahedraApproximation::ClassifyPoints(const PreparedVolume& prepared)
{
  const std::vector<float>& scalars = prepared.Scalars.Values;
  this->Values.resize(scalars.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(scalars.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->Values[i] = this->Approximation->Classify(prepared.Function.ValueAt(scalars[i]));
      }
    });
}

//------------------------------------------------------------------------------
void TetrahedraApproximation::ClassifyCenters(
  const PreparedVolume& prepared, const TetrahedraSelection& selection)
{
  const std::vector<float>& scalars = prepared.Scalars.Values;
  this->CenterValues.resize(static_cast<size_t>(selection.GetNumberOfCells()));
  vtkSMPTools::For(0, selection.GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const glm::vec4& weights = this->Shapes.GetSphere(static_cast<int>(cell)).Weights;
        float scalar = 0.0f;
        for (int i = 0; i < 4; ++i)
        {
          const vtkIdType at = prepared.Scalars.OnePerCell ? cell : selection.Corners[4 * cell + i];
          scalar += weights[i] * scalars[at];
        }
        this->CenterValues[cell] = prepared.Function.ValueAt(scalar);
      }
    });
}

//------------------------------------------------------------------------------
void TetrahedraApproximation::Prepare(const Settings& settings, const PreparedVolume& prepared,
  const TetrahedraSelection& selection, const CellProjectionFrame& frame)
{
  if (NeedsShapes(settings.Kind) &&
      (this->ShapesTime < prepared.CellsTime || this->MeshToWorld != frame.Rays.MeshToWorld))
  {
    this->MeshToWorld = frame.Rays.MeshToWorld;
    this->PrepareShapes(prepared, selection);
  }
  this->Approximation = this->Make(settings);
  if (this->Kind != settings.Kind || this->ValuesTime < prepared.FunctionTime ||
      this->ValuesTime < this->ShapesTime)
  {
    this->Kind = settings.Kind;
    this->ClassifyPoints(prepared);
    if (this->Kind == ApproximationKind::Centroid)
    {
      this->ClassifyCenters(prepared, selection);
    }
    this->ValuesTime.Modified();
  }
}

//------------------------------------------------------------------------------
bool TetrahedraApproximation::Draw(const PreparedVolume& prepared,
  const TetrahedraSelection& selection, const std::vector<unsigned int>& order,
  CellProjectionFrame& frame)
{
  this->Points.Build(prepared.Coordinates.Points, frame.Rays);
  const ApproximationTriangles triangles = ApproximatedCells::Build(
    { order, selection.Corners, this->Points, this->Values, prepared.Scalars.OnePerCell },
    *this->Approximation);
  return this->Raster.Draw(
    frame.Window, frame.GetRasterView(), triangles, this->Approximation->IsExponential());
}
