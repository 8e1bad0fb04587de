#include "vtkTetrahedraSimplifier.h"

#include "SimplifiedGrid.h"
#include "TetrahedraSimplification.h"
#include "VTKVersions.h"

#include "vtkConvexCells.h"
#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTetrahedraSimplifier);

namespace
{
constexpr int MaximumRepetitions = 3;
// How far from a plane, by the diagonal, is in it.
constexpr double Rounding = 1e-12;
// The output's scalars may be floats.
constexpr double RoomForRounding = 1e-6;

std::vector<double> PointsAbout(vtkUnstructuredGrid* grid, const double middle[3])
{
  std::vector<double> points(3 * static_cast<size_t>(grid->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    grid->GetPoint(i, &points[3 * i]);
    std::transform(&points[3 * i], &points[3 * i] + 3, middle, &points[3 * i],
      [](double x, double m) { return x - m; });
  }
  return points;
}

std::vector<double> ValuesOf(vtkDataArray* array)
{
  std::vector<double> values(static_cast<size_t>(array->GetNumberOfTuples()));
  for (size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetTuple1(static_cast<vtkIdType>(i));
  }
  return values;
}

std::vector<CollapsibleMesh::Tetrahedron> TetrahedraOf(vtkUnstructuredGrid* grid)
{
  std::vector<CollapsibleMesh::Tetrahedron> tetrahedra;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    grid->GetCellPoints(i, ids);
    CollapsibleMesh::Tetrahedron corners;
    std::transform(ids->begin(), ids->begin() + 4, corners.begin(),
      [](vtkIdType id) { return static_cast<int>(id); });
    tetrahedra.push_back(corners);
  }
  return tetrahedra;
}

double SizeOfRange(const std::vector<double>& values)
{
  const auto range = std::minmax_element(values.begin(), values.end());
  return values.empty() ? 0.0 : *range.second - *range.first;
}
}

//------------------------------------------------------------------------------
vtkTetrahedraSimplifier::vtkTetrahedraSimplifier()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
int vtkTetrahedraSimplifier::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  const double start = vtkTimerLog::GetUniversalTime();
  this->FieldError = this->BoundaryError = 0.0;
  this->NumberOfRepetitions = 0;
  vtkNew<vtkUnstructuredGrid> copy;
  copy->ShallowCopy(input);
  vtkNew<vtkConvexCells> convex;
  convex->SetInputData(copy);
  convex->TetrahedraOnlyOn();
  convex->Update();
  vtkUnstructuredGrid* tetrahedra = convex->GetOutput();
  this->NumberOfInputTetrahedra = tetrahedra->GetNumberOfCells();
  vtkDataArray* scalars = nullptr;
  if (tetrahedra->GetNumberOfCells() > 0)
  {
    scalars = this->FindScalars(inputVector, tetrahedra);
  }
  if (scalars)
  {
    this->Simplify(tetrahedra, scalars, output);
  }
  else
  {
    output->ShallowCopy(tetrahedra);
  }
  this->Seconds = vtkTimerLog::GetUniversalTime() - start;
  return 1;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkTetrahedraSimplifier::FindScalars(
  vtkInformationVector** inputVector, vtkUnstructuredGrid* tetrahedra)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_NONE;
  vtkDataArray* given = this->GetInputArrayToProcess(0, inputVector, association);
  const bool fits = given && association == vtkDataObject::FIELD_ASSOCIATION_POINTS &&
                    given->GetNumberOfComponents() == 1;
  // It may have no name, where it is the active one.
  vtkPointData* data = tetrahedra->GetPointData();
  vtkDataArray* scalars = !fits              ? nullptr
                          : given->GetName() ? data->GetArray(given->GetName())
                                             : data->GetScalars();
  if (!scalars)
  {
    vtkErrorMacro("No point scalars of one component to simplify by: call SetInputArrayToProcess. "
                  "The tetrahedra are passed on as they are.");
    return nullptr;
  }
  const std::vector<double> values = ValuesOf(scalars);
  const auto bad =
    std::count_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
  if (bad > 0)
  {
    vtkErrorMacro(<< bad << " points have scalars that are not finite: no error can be bounded. "
                  << "The tetrahedra are passed on as they are.");
    return nullptr;
  }
  return scalars;
}

//------------------------------------------------------------------------------
void vtkTetrahedraSimplifier::Simplify(
  vtkUnstructuredGrid* tetrahedra, vtkDataArray* scalars, vtkUnstructuredGrid* output)
{
  const double range = SizeOfRange(ValuesOf(scalars));
  const double bound = this->MaximumFieldError * (1.0 - RoomForRounding);
  SimplificationSettings settings;
  settings.FieldBound = bound * range;
  const double inPlane = Rounding * tetrahedra->GetLength();
  settings.BoundaryBound = std::max(inPlane, this->MaximumBoundaryError * tetrahedra->GetLength());
  settings.ShiftsScalars = this->ShiftScalars;
  double done = 0.0;
  settings.Progress = [&](double progress)
  {
    this->UpdateProgress(done + (1.0 - done) * progress);
    return !IsAborted(this);
  };
  while (this->SimplifyOnce(tetrahedra, scalars, settings, output) &&
         this->FieldError > this->MaximumFieldError + Rounding)
  {
    done = 0.5 + 0.5 * done;
    if (++this->NumberOfRepetitions > MaximumRepetitions)
    {
      output->ShallowCopy(tetrahedra);
      this->FieldError = this->BoundaryError = 0.0;
      return;
    }
    // Only what has come to lie outside can be off by more; of a boundary that stays nothing does.
    const bool isLast = this->NumberOfRepetitions == MaximumRepetitions;
    settings.BoundaryBound = isLast ? inPlane : std::max(inPlane, 0.1 * settings.BoundaryBound);
  }
}

//------------------------------------------------------------------------------
bool vtkTetrahedraSimplifier::SimplifyOnce(vtkUnstructuredGrid* tetrahedra, vtkDataArray* scalars,
  const SimplificationSettings& settings, vtkUnstructuredGrid* output)
{
  double middle[3];
  tetrahedra->GetCenter(middle);
  const std::vector<double> values = ValuesOf(scalars);
  TetrahedraSimplification simplification(
    PointsAbout(tetrahedra, middle), values, TetrahedraOf(tetrahedra), settings);
  if (!simplification.Run())
  {
    output->Initialize();
    return false;
  }
  vtkDataArray* simplified = SimplifiedGrid::Fill(simplification, tetrahedra, scalars, output);
  const double range = SizeOfRange(values);
  const double outside =
    SimplifiedGrid::FindOutsideError(simplification, middle, output, simplified);
  this->FieldError = range > 0.0 ? std::max(outside, simplification.FindFieldError()) / range : 0.0;
  this->BoundaryError = simplification.FindBoundaryError() / tetrahedra->GetLength();
  return true;
}

//------------------------------------------------------------------------------
void vtkTetrahedraSimplifier::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumFieldError: " << this->MaximumFieldError << "\n";
  os << indent << "MaximumBoundaryError: " << this->MaximumBoundaryError << "\n";
  os << indent << "ShiftScalars: " << (this->ShiftScalars ? "On" : "Off") << "\n";
  os << indent << "NumberOfInputTetrahedra: " << this->NumberOfInputTetrahedra << "\n";
  os << indent << "FieldError: " << this->FieldError << "\n";
  os << indent << "BoundaryError: " << this->BoundaryError << "\n";
  os << indent << "NumberOfRepetitions: " << this->NumberOfRepetitions << "\n";
  os << indent << "Seconds: " << this->Seconds << "\n";
}
