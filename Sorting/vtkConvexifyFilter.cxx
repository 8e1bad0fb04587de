#include "vtkConvexifyFilter.h"

#include "CellComplexReader.h"
#include "Convexification.h"
#include "ImaginaryGrid.h"
#include "VTKVersions.h"

#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkConvexifyFilter);

namespace
{
// Rounding leaves 1e-14; more is a boundary that runs through itself.
constexpr double LargestVolumeError = 1e-9;
}

//------------------------------------------------------------------------------
int vtkConvexifyFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  const double start = vtkTimerLog::GetUniversalTime();
  if (ImaginaryGrid::HasImaginaryCells(input))
  {
    output->ShallowCopy(input);
    this->Report(CellComplex(), ConvexificationResult());
    return 1;
  }
  CellComplex complex;
  CellComplexReader::Read(input, complex);
  const ConvexificationResult result = this->Convexify(complex);
  ImaginaryGrid::Append(input, result.Cells, output);
  if (result.VolumeError > LargestVolumeError)
  {
    // Without them a sort finds out by itself that nothing can be proven.
    output->GetFieldData()->RemoveArray("ImaginaryContacts");
  }
  this->Report(complex, result);
  this->Seconds = vtkTimerLog::GetUniversalTime() - start;
  return 1;
}

//------------------------------------------------------------------------------
ConvexificationResult vtkConvexifyFilter::Convexify(const CellComplex& complex)
{
  ConvexificationSettings settings;
  settings.ConvexHull = this->Enclosure == CONVEX_HULL;
  settings.DiscardOutsideHull = this->DiscardOutsideHull;
  settings.NumberOfCandidateCuts = this->NumberOfCandidateCuts;
  double shown = -1.0;
  settings.Progress = [&](double progress)
  {
    // An event a hundred times, not at each of many thousand cuts.
    if (progress - shown >= 0.01)
    {
      shown = progress;
      this->UpdateProgress(progress);
    }
    return !IsAborted(this);
  };
  return Convexification::Run(complex, settings);
}

//------------------------------------------------------------------------------
void vtkConvexifyFilter::Report(const CellComplex& complex, const ConvexificationResult& result)
{
  const ImaginaryCells& cells = result.Cells;
  this->NumberOfImaginaryCells = cells.GetNumberOfCells();
  this->NumberOfDiscardedCells = result.NumberOfDiscardedCells;
  this->FacesPerImaginaryCell =
    cells.GetNumberOfCells() == 0
      ? 0.0
      : static_cast<double>(cells.FaceOffsets.size() - 1) / cells.GetNumberOfCells();
  this->InputConvex = result.IsConvex;
  this->ImaginaryVolume = result.ImaginaryVolume;
  this->DiscardedVolume = result.DiscardedVolume;
  this->EnclosureVolume = result.EnclosureVolume;
  this->Seconds = 0.0;
  if (!complex.IsComplex() || result.VolumeError > LargestVolumeError)
  {
    vtkWarningMacro(
      "The mesh is no cell complex: "
      << complex.NumberOfNonManifoldFaces << " faces are shared by more than two cells, "
      << complex.NumberOfOverlappingFaces << " by cells on the same side, "
      << complex.NumberOfNonconformingPairs << " pairs of cells touch in faces that do not match, "
      << "and the imaginary cells miss " << 100.0 * result.VolumeError
      << " % of the enclosure. Its order cannot be proven.");
  }
}

//------------------------------------------------------------------------------
void vtkConvexifyFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enclosure: " << (this->Enclosure == CONVEX_HULL ? "ConvexHull" : "BoundingBox")
     << "\n";
  os << indent << "NumberOfCandidateCuts: " << this->NumberOfCandidateCuts << "\n";
  os << indent << "DiscardOutsideHull: " << (this->DiscardOutsideHull ? "On" : "Off") << "\n";
  os << indent << "NumberOfImaginaryCells: " << this->NumberOfImaginaryCells << "\n";
  os << indent << "NumberOfDiscardedCells: " << this->NumberOfDiscardedCells << "\n";
  os << indent << "FacesPerImaginaryCell: " << this->FacesPerImaginaryCell << "\n";
  os << indent << "InputConvex: " << (this->InputConvex ? "Yes" : "No") << "\n";
  os << indent << "ImaginaryVolume: " << this->ImaginaryVolume << "\n";
  os << indent << "DiscardedVolume: " << this->DiscardedVolume << "\n";
  os << indent << "EnclosureVolume: " << this->EnclosureVolume << "\n";
  os << indent << "Seconds: " << this->Seconds << "\n";
}
