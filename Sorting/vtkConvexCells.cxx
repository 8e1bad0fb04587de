#include "vtkConvexCells.h"

#include "ConvexCellConversion.h"
#include "VTKVersions.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkConvexCells);

namespace
{
// Of what FindSources returns, the last.
constexpr int NumberOfPointSources = 2;

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

vtkConvexCells::vtkConvexCells()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkConvexCells::~vtkConvexCells() = default;

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
  const bool curved = this->Last && this->Last->HasCurvedCells();
  const std::vector<vtkMTimeType> sources = this->FindSources(input, curved);
  if (this->HasKeptCells(input, sources))
  {
    this->LastSources = sources;
    this->Last->TakeDataFrom(input);
    this->Last->FillOutput(output);
    return 1;
  }
  this->TakeCounts(ConvexCellCounts{});
  this->Report->Initialize();
  this->Last = nullptr;
  auto conversion = std::make_unique<ConvexCellConversion>(input, this->TetrahedraOnly);
  if (this->Convert(*conversion, input))
  {
    conversion->FillOutput(output);
    this->TakeCounts(conversion->Count());
    conversion->Report(this->Report);
    conversion->ReleaseWorkingMemory();
    this->Last = std::move(conversion);
    this->LastSources = this->FindSources(input, this->Last->HasCurvedCells());
    this->UpdateProgress(1.0);
  }
  return 1;
}

bool vtkConvexCells::HasKeptCells(
  vtkUnstructuredGridBase* input, const std::vector<vtkMTimeType>& sources) const
{
  if (!this->Last || !this->Last->HasSameTypes(input))
  {
    return false;
  }
  const bool sameCells = sources.size() == this->LastSources.size() &&
                         std::equal(sources.begin(), sources.end() - NumberOfPointSources,
                           this->LastSources.begin());
  const bool samePoints = sameCells && sources == this->LastSources;
  return samePoints || (sameCells && this->KeepCells && this->Last->SharesPointsOf(input));
}

bool vtkConvexCells::Convert(ConvexCellConversion& conversion, vtkUnstructuredGridBase* input)
{
  conversion.ReadCells();
  this->UpdateProgress(0.05);
  conversion.MergePoints();
  this->UpdateProgress(0.1);
  if (conversion.HasCurvedCells() &&
      !conversion.RefineCurvedCells(
        this->FindFollowedArrays(input), this->Tolerance, [this] { return !IsAborted(this); }))
  {
    return false;
  }
  this->UpdateProgress(0.2);
  const auto plan = [&](vtkIdType begin, vtkIdType end) { conversion.PlanBlocks(begin, end); };
  const auto write = [&](vtkIdType begin, vtkIdType end) { conversion.WriteBlocks(begin, end); };
  const vtkIdType blocks = conversion.GetNumberOfBlocks();
  if (!RunInSteps(this, blocks, 0.2, 0.5, plan))
  {
    return false;
  }
  conversion.AllocateCells();
  return RunInSteps(this, blocks, 0.5, 0.8, write);
}

std::vector<vtkDataArray*> vtkConvexCells::FindFollowedArrays(vtkUnstructuredGridBase* input)
{
  int association = -1;
  vtkDataArray* chosen = this->GetInputArrayToProcess(0, input, association);
  if (chosen)
  {
    const bool fits = association == vtkDataObject::FIELD_ASSOCIATION_POINTS &&
                      chosen->GetNumberOfTuples() == input->GetNumberOfPoints();
    return fits ? std::vector<vtkDataArray*>{ chosen } : std::vector<vtkDataArray*>{};
  }
  std::vector<vtkDataArray*> arrays;
  vtkPointData* data = input->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const bool isReal =
      array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
    if (isReal && array->GetNumberOfTuples() == input->GetNumberOfPoints())
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

std::vector<vtkMTimeType> vtkConvexCells::FindSources(vtkUnstructuredGridBase* input, bool curved)
{
  std::vector<vtkMTimeType> times = { this->TetrahedraOnly };
  const auto add = [&times](vtkObject* source)
  { times.push_back(source ? source->GetMTime() : 0); };
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  vtkCellArray* cells = grid ? grid->GetCells() : nullptr;
  // Of other implementations nothing but the whole has a time.
  add(cells ? static_cast<vtkObject*>(cells) : input);
  add(cells ? cells->GetOffsetsArray() : nullptr);
  add(cells ? cells->GetConnectivityArray() : nullptr);
  if (grid)
  {
    for (vtkObject* faces : GetFaceArrays(grid))
    {
      add(faces);
    }
  }
  const char* ghosts = vtkDataSetAttributes::GhostArrayName();
  add(input->GetPointData()->GetArray(ghosts));
  add(input->GetCellData()->GetArray(ghosts));
  add(input->GetCellData()->GetArray("Imaginary"));
  if (curved)
  {
    add(input->GetCellData()->GetArray("HigherOrderDegrees"));
    add(input->GetPointData()->GetArray("RationalWeights"));
    for (vtkDataArray* array : this->FindFollowedArrays(input))
    {
      add(array);
    }
    times.push_back(static_cast<vtkMTimeType>(1e9 * this->Tolerance));
  }
  // Last, for they alone may move: NumberOfPointSources.
  vtkPoints* points = input->GetPoints();
  add(points);
  add(points ? points->GetData() : nullptr);
  return times;
}

void vtkConvexCells::TakeCounts(const ConvexCellCounts& counts)
{
  this->NumberOfMergedPoints = counts.MergedPoints;
  this->NumberOfDegenerateCells = counts.DegenerateCells;
  this->NumberOfDroppedTetrahedra = counts.DroppedTetrahedra;
  this->NumberOfInvertedCells = counts.InvertedCells;
  this->NumberOfFoldedCells = counts.FoldedCells;
  this->NumberOfNonConvexCells = counts.NonConvexCells;
  this->NumberOfSkippedCells = counts.SkippedCells;
  this->NumberOfZeroVolumeCells = counts.ZeroVolumeCells;
  this->NumberOfLowerDimensionalCells = counts.LowerDimensionalCells;
  this->NumberOfUnsupportedCells = counts.UnsupportedCells;
  this->NumberOfGhostCells = counts.GhostCells;
  this->NumberOfNonFiniteCells = counts.NonFiniteCells;
  this->NumberOfImaginaryCells = counts.ImaginaryCells;
  this->NumberOfConcaveCells = counts.ConcaveCells;
  this->NumberOfInvalidCells = counts.InvalidCells;
  this->NumberOfCoarseCells = counts.CoarseCells;
  this->LeftOutSummary = counts.LeftOutSummary;
}

void vtkConvexCells::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TetrahedraOnly: " << (this->TetrahedraOnly ? "On" : "Off") << "\n"
     << indent << "KeepCells: " << (this->KeepCells ? "On" : "Off") << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "NumberOfMergedPoints: " << this->NumberOfMergedPoints << "\n"
     << indent << "NumberOfDegenerateCells: " << this->NumberOfDegenerateCells << "\n"
     << indent << "NumberOfDroppedTetrahedra: " << this->NumberOfDroppedTetrahedra << "\n"
     << indent << "NumberOfInvertedCells: " << this->NumberOfInvertedCells << "\n"
     << indent << "NumberOfFoldedCells: " << this->NumberOfFoldedCells << "\n"
     << indent << "NumberOfNonConvexCells: " << this->NumberOfNonConvexCells << "\n"
     << indent << "NumberOfSkippedCells: " << this->NumberOfSkippedCells << "\n"
     << indent << "LeftOutSummary: " << this->LeftOutSummary << "\n";
}
