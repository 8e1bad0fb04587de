#include "vtkConvexifyFilter.h"

#include "CellComplexReader.h"
#include "Convexification.h"
#include "ImaginaryGrid.h"
#include "VTKVersions.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTimerLog.h"
#include "vtkTrivialProducer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkConvexifyFilter);

namespace
{
// Rounding leaves 1e-14; more is a boundary that runs through itself.
constexpr double LargestVolumeError = 1e-9;
}

//------------------------------------------------------------------------------
vtkConvexifyFilter::vtkConvexifyFilter() = default;

//------------------------------------------------------------------------------
vtkConvexifyFilter::~vtkConvexifyFilter() = default;

//------------------------------------------------------------------------------
void vtkConvexifyFilter::SetFillAlgorithm(vtkUnstructuredGridAlgorithm* algorithm)
{
  if (this->FillAlgorithm != algorithm)
  {
    this->FillAlgorithm = algorithm;
    if (algorithm)
    {
      algorithm->SetInputConnection(this->FillInput->GetOutputPort());
    }
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkConvexifyFilter::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->FillAlgorithm ? std::max(own, this->FillAlgorithm->GetMTime()) : own;
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
  if (this->FillMethod != ALGORITHM || !this->FillByAlgorithm(input, output))
  {
    this->FillByCuts(input, output);
  }
  this->Seconds = vtkTimerLog::GetUniversalTime() - start;
  return 1;
}

//------------------------------------------------------------------------------
bool vtkConvexifyFilter::FillByAlgorithm(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  if (!this->FillAlgorithm)
  {
    vtkErrorMacro(
      "FillMethod is Algorithm, but there is none: call SetFillAlgorithm. Cuts are made.");
    return false;
  }
  vtkNew<vtkUnstructuredGrid> copy;
  copy->ShallowCopy(input);
  this->FillInput->SetOutput(copy);
  this->FillAlgorithm->Update();
  vtkUnstructuredGrid* filled = this->FillAlgorithm->GetOutput();
  if (!filled->GetCellData()->HasArray("Imaginary"))
  {
    vtkErrorMacro("The FillAlgorithm, a "
                  << this->FillAlgorithm->GetClassName()
                  << ", gives no array Imaginary (vtkTetGenTetrahedralizer: "
                     "call SetModeToFillHull). Cuts are made.");
    return false;
  }
  output->ShallowCopy(filled);
  const vtkIdType cells = input->GetNumberOfCells();
  const ImaginaryGrid::Size mesh = ImaginaryGrid::Measure(output, 0, cells);
  const ImaginaryGrid::Size added =
    ImaginaryGrid::Measure(output, cells, output->GetNumberOfCells());
  this->Report(CellComplex(), ConvexificationResult());
  this->NumberOfImaginaryCells = output->GetNumberOfCells() - cells;
  this->InputConvex = this->NumberOfImaginaryCells == 0;
  this->FacesPerImaginaryCell =
    this->InputConvex ? 0.0 : static_cast<double>(added.Faces) / this->NumberOfImaginaryCells;
  this->ImaginaryVolume = added.Volume;
  this->EnclosureVolume = mesh.Volume + added.Volume;
  return true;
}

//------------------------------------------------------------------------------
void vtkConvexifyFilter::FillByCuts(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
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
  os << indent << "FillMethod: " << (this->FillMethod == CUTS ? "Cuts" : "Algorithm") << "\n";
  os << indent
     << "FillAlgorithm: " << (this->FillAlgorithm ? this->FillAlgorithm->GetClassName() : "(none)")
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
