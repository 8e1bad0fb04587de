#include "IsoSurfaces.h"

#include "CellProjectionFrame.h"
#include "ElementBuffers.h"
#include "MeshExtent.h"
#include "PreparedVolume.h"
#include "VolumePropertyReader.h"
#include "vtkContourValues.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
IsoSurfaces::IsoSurfaces()
{
  this->Shading.TakesColors = false;
}

//------------------------------------------------------------------------------
void IsoSurfaces::TakeValues(const CellProjectionFrame& frame, const PreparedVolume& prepared,
  std::vector<std::string>& problems)
{
  vtkVolumeProperty* property = frame.Volume->GetProperty();
  vtkContourValues* contours = property->GetIsoSurfaceValues();
  const double low = prepared.Scalars.Normal[0];
  const double width = prepared.Scalars.Normal[1] - low;
  this->Values.clear();
  // What a gradient opacity leaves of each point is found where it is drawn.
  this->IsOpaque = !VolumePropertyReader(property).HasGradientOpacity();
  int skipped = 0;
  for (int i = 0; i < contours->GetNumberOfContours(); ++i)
  {
    const double value = contours->GetValue(i);
    const bool isFinite = std::isfinite(value);
    skipped += isFinite ? 0 : 1;
    const double opacity = isFinite ? property->GetScalarOpacity()->GetValue(value) : 0.0;
    // A mesh of one scalar has none.
    if (width > 0.0 && opacity > 0.0 && !prepared.Scalars.OnePerCell)
    {
      this->Values.push_back(static_cast<float>((value - low) / width));
      this->IsOpaque = this->IsOpaque && opacity >= 1.0;
    }
  }
  this->CheckValues(
    contours->GetNumberOfContours(), skipped, prepared.Scalars.OnePerCell, problems);
}

//------------------------------------------------------------------------------
void IsoSurfaces::CheckValues(
  int count, int skipped, bool onePerCell, std::vector<std::string>& problems)
{
  if (count == 0)
  {
    problems.emplace_back("The property has no iso-surface values: nothing is drawn; call "
                          "GetIsoSurfaceValues()->SetValue(0, ...).");
  }
  if (skipped > 0)
  {
    problems.push_back(std::to_string(skipped) +
                       " of the iso-surface values are not finite: they are not drawn.");
  }
  if (onePerCell)
  {
    problems.emplace_back("Scalars that are constant in their cells have no iso-surface: nothing "
                          "is drawn; take point scalars.");
  }
  if (this->Values.size() > IsoRaster::MaximumValues)
  {
    problems.push_back(std::to_string(this->Values.size()) + " iso-surface values are set: the " +
                       "first " + std::to_string(IsoRaster::MaximumValues) + " are drawn.");
    this->Values.resize(IsoRaster::MaximumValues);
  }
}

//------------------------------------------------------------------------------
bool IsoSurfaces::IsEmpty(float low, float high) const
{
  return std::none_of(this->Values.begin(), this->Values.end(),
    [=](float value) { return value >= low && value <= high; });
}

//------------------------------------------------------------------------------
void IsoSurfaces::MakeTriangles(const PreparedVolume& prepared, const std::vector<int>& corners,
  const vtkTimeStamp& cornersTime)
{
  if (this->TriangleSource.CutTime < cornersTime || this->TriangleSource.CutTime < prepared.ScalarsTime ||
      this->Values != this->CutValues)
  {
    this->Triangles.Cut(corners, prepared.Scalars.Values, this->Values);
    this->CutValues = this->Values;
    this->TriangleSource.CutTime.Modified();
  }
  if (this->TriangleSource.VerticesTime < this->TriangleSource.CutTime ||
      this->TriangleSource.VerticesTime < prepared.PointsTime)
  {
    this->Triangles.Move(corners, prepared.Coordinates.Points);
    this->TriangleSource.VerticesTime.Modified();
  }
}

//------------------------------------------------------------------------------
void IsoSurfaces::ShadeTriangles(const PreparedVolume& prepared)
{
  if (this->WantsAllPoints || this->WantedTime < this->TriangleSource.CutTime)
  {
    this->WantedPoints = this->Triangles.FindPoints(prepared.Coordinates.Points.size() / 4);
    this->Shading.SetWantedPoints(&this->WantedPoints);
    this->WantsAllPoints = false;
    this->WantedTime.Modified();
  }
}

//------------------------------------------------------------------------------
bool IsoSurfaces::Shade(const CellProjectionFrame& frame, const PreparedVolume& prepared,
  const std::vector<int>& corners, const vtkTimeStamp& cornersTime)
{
  const bool isLit = frame.Volume->GetProperty()->GetShade() != 0;
  if (!this->IsOpaque && !this->WantsAllPoints)
  {
    this->Shading.SetWantedPoints(nullptr);
    this->WantsAllPoints = true;
  }
  if (this->IsOpaque && isLit)
  {
    this->ShadeTriangles(prepared);
  }
  this->Failure.clear();
  this->Shading.Prepare(frame, prepared, corners, cornersTime, this->Failure);
  if (!this->IsOpaque)
  {
    return this->Buffers.Upload(frame.Window, this->Shading);
  }
  this->Buffers.TakeLights(this->Shading);
  if (isLit && (this->TriangleSource.GradientsTime < this->Shading.GradientsTime ||
                 this->TriangleSource.GradientsTime < this->TriangleSource.CutTime))
  {
    this->Triangles.Shade(this->Shading.Gradients.Values);
    this->TriangleSource.GradientsTime.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
IsoRaster::View IsoSurfaces::MakeView(
  const CellProjectionFrame& frame, const PreparedVolume& prepared)
{
  IsoRaster::View view;
  static_cast<RasterView&>(view) = frame.GetRasterView();
  this->Depths = MeshExtent::FindDepths(prepared.Coordinates, view);
  view.Depths = this->Depths;
  view.Values = this->Values;
  if (this->IsOpaque)
  {
    this->TriangleSource.Triangles = &this->Triangles;
    this->TriangleSource.Colors.clear();
    for (const IsoTriangles::Surface& surface : this->Triangles.Surfaces)
    {
      this->TriangleSource.Colors.emplace_back(prepared.Function.ValueAt(surface.Value));
    }
    view.Triangles = &this->TriangleSource;
  }
  return view;
}

//------------------------------------------------------------------------------
bool IsoSurfaces::DrawIntoWindow(const CellProjectionFrame& frame, const PreparedVolume& prepared,
  const std::vector<int>& corners, const vtkTimeStamp& cornersTime)
{
  this->Shade(frame, prepared, corners, cornersTime);
  const IsoRaster::View view = this->MakeView(frame, prepared);
  const bool drawn = this->Raster.DrawIntoWindow(frame.Window, view, frame.Origin, this->Buffers);
  this->Failure = drawn ? this->Failure : this->Raster.GetFailure();
  return drawn;
}

//------------------------------------------------------------------------------
bool IsoSurfaces::Draw(const CellProjectionFrame& frame, const PreparedVolume& prepared,
  const std::vector<int>& corners, const vtkTimeStamp& cornersTime,
  const std::vector<int>& vertices, ElementBuffers& buffers)
{
  if (!this->Shade(frame, prepared, corners, cornersTime))
  {
    this->Failure = this->Buffers.GetFailure();
    return false;
  }
  IsoRaster::View view = this->MakeView(frame, prepared);
  view.Vertices = &vertices;
  const bool drawn = this->Raster.Draw(frame.Window, view, buffers, this->Buffers);
  this->Failure = drawn ? this->Failure : this->Raster.GetFailure();
  return drawn;
}

//------------------------------------------------------------------------------
void IsoSurfaces::DrawDepth(const CellProjectionFrame& frame)
{
  IsoRaster::View view;
  static_cast<RasterView&>(view) = frame.GetRasterView();
  view.Depths = this->Depths;
  this->Raster.DrawDepth(frame.Window, view, frame.Origin);
}

//------------------------------------------------------------------------------
void IsoSurfaces::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Buffers.ReleaseGraphicsResources(window);
  this->Raster.ReleaseGraphicsResources(window);
}
