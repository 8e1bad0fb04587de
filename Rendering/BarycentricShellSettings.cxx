// What is set on vtkBarycentricShellMapper, and what it says of its last frame.

#include "BarycentricShellInternals.h"
#include "vtkBarycentricShellMapper.h"
#include "vtkOpenGLRenderWindow.h"

#include <cmath>

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SetSampleDistance(double distance)
{
  if (!(distance > 0.0) || !std::isfinite(distance))
  {
    vtkErrorMacro("SampleDistance is " << distance << ": it must be positive; "
                                       << this->SampleDistance << " stays.");
  }
  else if (distance != this->SampleDistance || this->SamplesPerRay != 0.0)
  {
    this->SampleDistance = distance;
    this->SamplesPerRay = 0.0;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SetSamplesPerRay(double samples)
{
  if (!(samples > 0.0) || !std::isfinite(samples))
  {
    vtkErrorMacro("SamplesPerRay is " << samples << ": it must be positive; "
                                      << this->SamplesPerRay << " stays.");
  }
  else if (samples != this->SamplesPerRay)
  {
    this->SamplesPerRay = samples;
    this->SampleDistance = 0.0;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SetSamplesPerShell(int samples)
{
  if (samples != 4 && samples != 8 && samples != 16)
  {
    vtkErrorMacro("SamplesPerShell is " << samples << ": it is 4, 8 or 16.");
  }
  else if (samples != this->SamplesPerShell)
  {
    this->SamplesPerShell = samples;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SetMemoryLimit(double limit)
{
  if (!(limit >= 0.0) || !std::isfinite(limit))
  {
    vtkErrorMacro("MemoryLimit is " << limit << " MiB: it must not be negative; "
                                    << this->MemoryLimit << " stays.");
  }
  else if (limit != this->MemoryLimit)
  {
    this->MemoryLimit = limit;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SetVisibilitySort(vtkVisibilitySort* sort)
{
  if (this->Internal->Sort != sort)
  {
    this->Internal->Sort = sort;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkVisibilitySort* vtkBarycentricShellMapper::GetVisibilitySort()
{
  return this->Internal->Sort;
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SetVolumeTexture(vtkImageData* image)
{
  if (this->Internal->Texture != image)
  {
    this->Internal->Texture = image;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkBarycentricShellMapper::GetVolumeTexture()
{
  return this->Internal->Texture;
}

//------------------------------------------------------------------------------
vtkIdType vtkBarycentricShellMapper::GetNumberOfElementsDrawn() const
{
  return this->Internal->IsInShells ? this->Internal->Shells.GetNumberOfElements() : 0;
}

//------------------------------------------------------------------------------
int vtkBarycentricShellMapper::GetNumberOfShells() const
{
  return this->Internal->IsInShells ? this->Internal->Shells.GetNumberOfShells() : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkBarycentricShellMapper::GetMeshBytes() const
{
  const Internals& internal = *this->Internal;
  return static_cast<vtkIdType>(this->BlendMode == ISOSURFACE && internal.Surfaces.AreTriangles()
      ? internal.Surfaces.GetTriangleRaster().GetNumberOfBytes()
      : internal.Buffers.GetNumberOfBytes());
}

//------------------------------------------------------------------------------
vtkIdType vtkBarycentricShellMapper::GetTargetBytes() const
{
  return this->Internal->IsInShells ? this->Internal->TargetBytes : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkBarycentricShellMapper::GetUploadedBytes() const
{
  const Internals& internal = *this->Internal;
  return static_cast<vtkIdType>(this->BlendMode == ISOSURFACE && internal.Surfaces.AreTriangles()
      ? internal.Surfaces.GetTriangleRaster().GetUploadedBytes()
      : internal.Buffers.GetUploadedBytes());
}

//------------------------------------------------------------------------------
double vtkBarycentricShellMapper::GetUploadSeconds() const
{
  const Internals& internal = *this->Internal;
  return this->BlendMode == ISOSURFACE && internal.Surfaces.AreTriangles()
    ? internal.Surfaces.GetTriangleRaster().GetUploadSeconds()
    : internal.Buffers.GetUploadSeconds();
}

//------------------------------------------------------------------------------
vtkIdType vtkBarycentricShellMapper::GetNumberOfTurnedCells() const
{
  return this->Internal->Elements.NumberOfTurnedCells;
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "SamplesPerRay: " << this->SamplesPerRay << "\n";
  os << indent << "SamplesPerShell: " << this->SamplesPerShell << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "VisibilitySort: " << this->Internal->Sort.GetPointer() << "\n";
  os << indent << "Integration: " << this->Integration << "\n";
}
