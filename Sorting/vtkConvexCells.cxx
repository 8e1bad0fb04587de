#include "vtkConvexCells.h"

#include "ConvexCellConversion.h"
#include "VTKVersions.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkConvexCells);

namespace
{
// False when the user has aborted. `step` is given ranges of 0 .. count.
template <typename Step>
bool RunInSteps(vtkAlgorithm* filter, vtkIdType count, double from, double to, Step step)
{
  const vtkIdType stride = std::max<vtkIdType>(64, count / 16 + 1);
  for (vtkIdType begin = 0; begin < count; begin += stride)
  {
    if (IsAborted(filter))
    {
      return false;
    }
    const vtkIdType end = std::min(begin + stride, count);
    step(begin, end);
    filter->UpdateProgress(from + (to - from) * static_cast<double>(end) / count);
  }
  return !IsAborted(filter);
}
}

int vtkConvexCells::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGridBase");
  return 1;
}

int vtkConvexCells::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = vtkUnstructuredGridBase::GetData(inputVector[0]);
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  if (!input || !output)
  {
    vtkErrorMacro("The input is no vtkUnstructuredGridBase: connect an unstructured grid.");
    return 0;
  }
  this->TakeCounts(ConvexCellCounts{});
  ConvexCellConversion conversion(input, this->TetrahedraOnly);
  conversion.ReadCells();
  this->UpdateProgress(0.05);
  conversion.MergePoints();
  this->UpdateProgress(0.2);
  const auto plan = [&](vtkIdType begin, vtkIdType end) { conversion.PlanBlocks(begin, end); };
  const auto write = [&](vtkIdType begin, vtkIdType end) { conversion.WriteBlocks(begin, end); };
  const vtkIdType blocks = conversion.GetNumberOfBlocks();
  if (!RunInSteps(this, blocks, 0.2, 0.5, plan))
  {
    return 1;
  }
  conversion.AllocateCells();
  if (!RunInSteps(this, blocks, 0.5, 0.8, write))
  {
    return 1;
  }
  conversion.FillOutput(output);
  this->TakeCounts(conversion.Count());
  this->UpdateProgress(1.0);
  return 1;
}

void vtkConvexCells::TakeCounts(const ConvexCellCounts& counts)
{
  this->NumberOfMergedPoints = counts.MergedPoints;
  this->NumberOfDegenerateCells = counts.DegenerateCells;
  this->NumberOfDroppedTetrahedra = counts.DroppedTetrahedra;
  this->NumberOfInvertedCells = counts.InvertedCells;
  this->NumberOfFoldedCells = counts.FoldedCells;
  this->NumberOfSkippedCells = counts.SkippedCells;
  this->NumberOfZeroVolumeCells = counts.ZeroVolumeCells;
  this->NumberOfLowerDimensionalCells = counts.LowerDimensionalCells;
  this->NumberOfUnsupportedCells = counts.UnsupportedCells;
  this->NumberOfGhostCells = counts.GhostCells;
  this->NumberOfNonFiniteCells = counts.NonFiniteCells;
  this->NumberOfInvalidCells = counts.InvalidCells;
  this->LeftOutSummary = counts.LeftOutSummary;
}

void vtkConvexCells::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TetrahedraOnly: " << (this->TetrahedraOnly ? "On" : "Off") << "\n"
     << indent << "NumberOfMergedPoints: " << this->NumberOfMergedPoints << "\n"
     << indent << "NumberOfDegenerateCells: " << this->NumberOfDegenerateCells << "\n"
     << indent << "NumberOfDroppedTetrahedra: " << this->NumberOfDroppedTetrahedra << "\n"
     << indent << "NumberOfInvertedCells: " << this->NumberOfInvertedCells << "\n"
     << indent << "NumberOfFoldedCells: " << this->NumberOfFoldedCells << "\n"
     << indent << "NumberOfSkippedCells: " << this->NumberOfSkippedCells << "\n"
     << indent << "LeftOutSummary: " << this->LeftOutSummary << "\n";
}
