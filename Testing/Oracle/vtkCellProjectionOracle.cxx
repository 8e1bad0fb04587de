#include "vtkCellProjectionOracle.h"

#include "OracleCamera.h"
#include "OracleFunctions.h"
#include "OracleGridReader.h"
#include "OracleIntegrator.h"
#include "OracleLightReader.h"
#include "OracleMatrix.h"
#include "OracleStatistics.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace
{
OracleVector MakeVector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

OracleIntegrator::Rgba Blend(int mode, const OracleIntegrator& integrator,
  const std::vector<OracleSegment>& segments, const OracleRay& ray)
{
  switch (mode)
  {
    case vtkCellProjectionOracle::MAXIMUM_INTENSITY_BLEND:
      return integrator.Maximum(segments);
    case vtkCellProjectionOracle::MINIMUM_INTENSITY_BLEND:
      return integrator.Minimum(segments);
    case vtkCellProjectionOracle::ADDITIVE_BLEND:
      return integrator.Add(segments, ray);
    default:
      return integrator.Composite(segments, ray);
  }
}

std::array<double, 4> GetPixel(vtkDataArray* pixels, vtkIdType index)
{
  std::array<double, 4> pixel;
  pixels->GetTuple(index, pixel.data());
  return pixel;
}
}

vtkStandardNewMacro(vtkCellProjectionOracle);
vtkCxxSetSmartPointerMacro(vtkCellProjectionOracle, InputData, vtkUnstructuredGrid);
vtkCxxSetSmartPointerMacro(vtkCellProjectionOracle, Volume, vtkVolume);
vtkCxxSetSmartPointerMacro(vtkCellProjectionOracle, Camera, vtkCamera);
vtkCxxSetSmartPointerMacro(vtkCellProjectionOracle, Lights, vtkLightCollection);
vtkCxxSetSmartPointerMacro(vtkCellProjectionOracle, ClippingPlanes, vtkPlaneCollection);
vtkCxxSetSmartPointerMacro(vtkCellProjectionOracle, OpaqueDepth, vtkDataArray);

//------------------------------------------------------------------------------
vtkCellProjectionOracle::vtkCellProjectionOracle()
{
  this->ForgetComparison();
}

//------------------------------------------------------------------------------
vtkCellProjectionOracle::~vtkCellProjectionOracle() = default;

//------------------------------------------------------------------------------
void vtkCellProjectionOracle::SetSize(int width, int height)
{
  this->Size[0] = width;
  this->Size[1] = height;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkCellProjectionOracle::SetBlendMode(int mode)
{
  this->BlendMode = mode;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkCellProjectionOracle::SetArrayName(const char* name)
{
  this->ArrayName = name ? name : "";
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkCellProjectionOracle::SetCellScalars(bool cellScalars)
{
  this->CellScalars = cellScalars;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkCellProjectionOracle::Update()
{
  this->Image = nullptr;
  this->Segments.clear();
  vtkDataArray* scalars =
    this->CheckInputs() && this->CheckNumbers() ? this->FindScalars() : nullptr;
  if (!scalars)
  {
    return false;
  }
  const OracleMatrix::Values dataToWorld = OracleMatrix::Copy(this->Volume->GetMatrix());
  const bool areIndependent = this->Volume->GetProperty()->GetIndependentComponents() != 0;
  const OracleGridReader reader(
    this->InputData, scalars, this->CellScalars, areIndependent, dataToWorld);
  const OracleVector center = reader.GetCenter();
  const double zero[3] = { center.X, center.Y, center.Z };
  std::unique_ptr<OracleCamera> camera;
  if (!this->CreateCamera(zero, camera))
  {
    return false;
  }
  const bool withGradients = this->NeedsGradients();
  const bool hasOwnColors = reader.GetColors() != OracleColors::OfScalar;
  if ((withGradients || hasOwnColors) && !reader.HasTetrahedraOnly())
  {
    vtkErrorMacro("Shading, gradient opacity and dependent components need tetrahedra alone: cut the "
                  "cells up first.");
    return false;
  }
  this->Draw(*camera, reader.Read(withGradients), reader.GetColors());
  return true;
}

//------------------------------------------------------------------------------
bool vtkCellProjectionOracle::NeedsGradients()
{
  vtkVolumeProperty* property = this->Volume->GetProperty();
  return this->BlendMode == COMPOSITE_BLEND &&
         (property->GetShade() || OracleFunctions(property).HasGradientOpacity());
}

//------------------------------------------------------------------------------
bool vtkCellProjectionOracle::CheckInputs()
{
  if (!this->InputData)
  {
    vtkErrorMacro("There is no input: call SetInputData.");
    return false;
  }
  if (!this->Volume)
  {
    vtkErrorMacro("There is no volume: call SetVolume.");
    return false;
  }
  if (!this->Camera)
  {
    vtkErrorMacro("There is no camera: call SetCamera.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkCellProjectionOracle::CheckNumbers()
{
  if (this->Size[0] < 1 || this->Size[1] < 1)
  {
    vtkErrorMacro("The size " << this->Size[0] << " x " << this->Size[1] << " has no pixels.");
    return false;
  }
  const int modes[] = { COMPOSITE_BLEND, MAXIMUM_INTENSITY_BLEND, MINIMUM_INTENSITY_BLEND,
    ADDITIVE_BLEND };
  if (std::find(std::begin(modes), std::end(modes), this->BlendMode) == std::end(modes))
  {
    vtkErrorMacro("The blend mode " << this->BlendMode << " is not 0, 1, 2 or 4.");
    return false;
  }
  const double unitDistance = this->Volume->GetProperty()->GetScalarOpacityUnitDistance();
  if (!(unitDistance > 0.0))
  {
    vtkErrorMacro("The unit distance " << unitDistance << " is not positive.");
    return false;
  }
  const vtkIdType pixels = static_cast<vtkIdType>(this->Size[0]) * this->Size[1];
  if (this->OpaqueDepth && this->OpaqueDepth->GetNumberOfTuples() != pixels)
  {
    vtkErrorMacro("The opaque depth has " << this->OpaqueDepth->GetNumberOfTuples()
                                          << " values where the image has " << pixels
                                          << " pixels.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkCellProjectionOracle::FindScalars()
{
  vtkDataSetAttributes* data = this->InputData->GetPointData();
  if (this->CellScalars)
  {
    data = this->InputData->GetCellData();
  }
  vtkDataArray* scalars =
    this->ArrayName.empty() ? data->GetScalars() : data->GetArray(this->ArrayName.c_str());
  if (!scalars)
  {
    vtkErrorMacro("The input has no " << (this->CellScalars ? "cell" : "point") << " array '"
                                      << this->ArrayName << "' (empty: active scalars).");
  }
  return scalars;
}

//------------------------------------------------------------------------------
bool vtkCellProjectionOracle::CreateCamera(
  const double center[3], std::unique_ptr<OracleCamera>& camera)
{
  const double aspect = static_cast<double>(this->Size[0]) / this->Size[1];
  OracleMatrix::Values clipToView, viewToWorld;
  if (!OracleMatrix::Invert(this->Camera->GetProjectionTransformMatrix(aspect, -1, 1), clipToView) ||
      !OracleMatrix::Invert(this->Camera->GetViewTransformMatrix(), viewToWorld))
  {
    vtkErrorMacro("The camera's view or projection matrix has no inverse.");
    return false;
  }
  camera = std::make_unique<OracleCamera>(
    clipToView, viewToWorld, MakeVector(center), this->Size[0], this->Size[1]);
  const int planes = this->ClippingPlanes ? this->ClippingPlanes->GetNumberOfItems() : 0;
  for (int index = 0; index < planes; ++index)
  {
    vtkPlane* plane = vtkPlane::SafeDownCast(this->ClippingPlanes->GetItemAsObject(index));
    camera->AddClippingPlane(MakeVector(plane->GetOrigin()), MakeVector(plane->GetNormal()));
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkCellProjectionOracle::Draw(
  const OracleCamera& camera, const OracleCells& cells, OracleColors colors)
{
  this->Image = vtkSmartPointer<vtkImageData>::New();
  this->Image->SetDimensions(this->Size[0], this->Size[1], 1);
  this->Image->AllocateScalars(VTK_DOUBLE, 4);
  this->Segments.assign(static_cast<std::size_t>(this->Size[0]) * this->Size[1], 0);
  double* pixels = static_cast<double*>(this->Image->GetScalarPointer());
  const OracleFunctions functions(this->Volume->GetProperty());
  const OracleLightReader lights(this->Camera, camera.GetCenter());
  const OracleShading shading = lights.Read(this->Volume->GetProperty(), this->Lights);
  const bool isLit =
    this->BlendMode == COMPOSITE_BLEND && this->Volume->GetProperty()->GetShade() != 0;
  const OracleIntegrator integrator(functions, isLit ? &shading : nullptr, colors);
  vtkSMPTools::For(0, this->Size[1], 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        this->DrawRow(static_cast<int>(row), camera, cells, integrator, pixels);
      }
    });
}

//------------------------------------------------------------------------------
void vtkCellProjectionOracle::DrawRow(int row, const OracleCamera& camera, const OracleCells& cells,
  const OracleIntegrator& integrator, double* pixels)
{
  std::vector<OracleSegment> segments;
  for (int column = 0; column < this->Size[0]; ++column)
  {
    const vtkIdType index = static_cast<vtkIdType>(row) * this->Size[0] + column;
    const double depth = this->OpaqueDepth ? this->OpaqueDepth->GetComponent(index, 0) : 1.0;
    const OracleRay ray = camera.GetRay(column, row, depth);
    cells.Clip(ray, segments);
    const OracleIntegrator::Rgba pixel = Blend(this->BlendMode, integrator, segments, ray);
    std::copy(pixel.begin(), pixel.end(), pixels + 4 * index);
    this->Segments[index] = static_cast<vtkIdType>(segments.size());
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkCellProjectionOracle::GetImage()
{
  return this->Image;
}

//------------------------------------------------------------------------------
vtkIdType vtkCellProjectionOracle::GetNumberOfSegments()
{
  return std::accumulate(this->Segments.begin(), this->Segments.end(), vtkIdType(0));
}

//------------------------------------------------------------------------------
void vtkCellProjectionOracle::Compare(vtkImageData* captured)
{
  this->ForgetComparison();
  if (!this->CheckCaptured(captured))
  {
    return;
  }
  vtkDataArray* oracle = this->Image->GetPointData()->GetScalars();
  vtkDataArray* other = captured->GetPointData()->GetScalars();
  OracleStatistics statistics;
  for (vtkIdType index = 0; index < oracle->GetNumberOfTuples(); ++index)
  {
    statistics.AddPixel(GetPixel(oracle, index), GetPixel(other, index), this->Segments[index] > 0);
  }
  this->CollectStatistics(statistics);
}

//------------------------------------------------------------------------------
bool vtkCellProjectionOracle::CheckCaptured(vtkImageData* captured)
{
  if (!this->Image)
  {
    vtkErrorMacro("There is no image to compare with: call Update.");
    return false;
  }
  vtkDataArray* pixels = captured ? captured->GetPointData()->GetScalars() : nullptr;
  if (!pixels || pixels->GetNumberOfComponents() != 4)
  {
    vtkErrorMacro("The captured image has no scalars of 4 components.");
    return false;
  }
  const int* size = captured->GetDimensions();
  if (!std::equal(size, size + 3, this->Image->GetDimensions()))
  {
    vtkErrorMacro("The captured image is "
                  << size[0] << " x " << size[1] << " where the oracle's is "
                  << this->Image->GetDimensions()[0] << " x " << this->Image->GetDimensions()[1]
                  << ".");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkCellProjectionOracle::CollectStatistics(const OracleStatistics& statistics)
{
  this->RootMeanSquareError = statistics.GetRootMeanSquareError();
  this->PercentileError = statistics.GetPercentileError(0.999);
  this->MaximumError = statistics.GetMaximumError();
  this->ShareAboveHalfLevel = statistics.GetShareAboveHalfLevel();
  this->NumberOfCoveredPixels = statistics.GetNumberOfCoveredPixels();
  const long long index = statistics.GetMaximumErrorIndex();
  const int width = this->Image->GetDimensions()[0];
  this->MaximumErrorPixel[0] = index < 0 ? -1 : static_cast<int>(index % width);
  this->MaximumErrorPixel[1] = index < 0 ? -1 : static_cast<int>(index / width);
}

//------------------------------------------------------------------------------
void vtkCellProjectionOracle::ForgetComparison()
{
  const double infinity = std::numeric_limits<double>::infinity();
  this->RootMeanSquareError = infinity;
  this->PercentileError = infinity;
  this->MaximumError = infinity;
  this->ShareAboveHalfLevel = infinity;
  this->NumberOfCoveredPixels = 0;
  this->MaximumErrorPixel[0] = -1;
  this->MaximumErrorPixel[1] = -1;
}

//------------------------------------------------------------------------------
void vtkCellProjectionOracle::GetMaximumErrorPixel(int pixel[2])
{
  std::copy_n(this->MaximumErrorPixel, 2, pixel);
}

//------------------------------------------------------------------------------
void vtkCellProjectionOracle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size[0] << " x " << this->Size[1] << "\n";
  os << indent << "BlendMode: " << this->BlendMode << "\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "CellScalars: " << this->CellScalars << "\n";
  os << indent << "InputData: " << this->InputData << "\n";
  os << indent << "Volume: " << this->Volume << "\n";
  os << indent << "Camera: " << this->Camera << "\n";
  os << indent << "Lights: " << this->Lights << "\n";
  os << indent << "ClippingPlanes: " << this->ClippingPlanes << "\n";
  os << indent << "OpaqueDepth: " << this->OpaqueDepth << "\n";
  os << indent << "Image: " << this->Image << "\n";
  os << indent << "NumberOfSegments: " << this->GetNumberOfSegments() << "\n";
  os << indent << "RootMeanSquareError: " << this->RootMeanSquareError << "\n";
  os << indent << "PercentileError: " << this->PercentileError << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "ShareAboveHalfLevel: " << this->ShareAboveHalfLevel << "\n";
  os << indent << "NumberOfCoveredPixels: " << this->NumberOfCoveredPixels << "\n";
}
