#include "vtkProvenVisibilitySort.h"

#include "CellComplexReader.h"
#include "Convexification.h"
#include "ImaginaryGrid.h"
#include "MeshTime.h"
#include "OrderProof.h"
#include "ViewEye.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

/// What the sort keeps from traversal to traversal.
class vtkProvenVisibilitySort::Internals
{
public:
  std::array<double, 4> Eye{ { 0.0, 0.0, 0.0, 1.0 } };
  // The subclass' own, or, where cells had to be left out, the copy.
  const std::vector<vtkIdType>* Order = nullptr;
  std::vector<vtkIdType> Filtered;
  vtkIdType Next = 0;
  vtkNew<vtkIdTypeArray> Batch;
  std::vector<vtkIdType> Reversed;

  // What the order was made for.
  MeshTime OrderedCells{};
  vtkMTimeType OrderedSort = 0;
  std::array<double, 4> OrderedEye{ { 0.0, 0.0, 0.0, 0.0 } };
  vtkDataSet* OrderedInput = nullptr;

  // What one input costs to build.
  struct Preparation
  {
    CellComplex Complex;
    ImaginaryCells Imaginary;
    bool IsFilled = false;
    // What the imaginary cells miss of the hull, as a share of it.
    double VolumeError = 0.0;
    bool HasComplex = false;
    bool HasImaginary = false;
    bool Reported = false;
    // What it was made from.
    MeshTime Cells{};
    vtkDataSet* Input = nullptr;
    bool Convexify = true;
  };
  Preparation Built;
  std::string LastFailure;

  // Answers, computed when asked for.
  vtkIdType Misordered = -1;
  vtkSmartPointer<vtkCellArray> Groups;
};

namespace
{
// Cells that are never returned, wherever they stand in the input.
void DropImaginary(vtkDataSet* input, std::vector<vtkIdType>& order)
{
  auto* marks = vtkUnsignedCharArray::SafeDownCast(input->GetCellData()->GetArray("Imaginary"));
  order.erase(std::remove_if(order.begin(), order.end(),
                [marks](vtkIdType cell) { return marks->GetValue(cell) != 0; }),
    order.end());
}

// Largest share of the enclosure that rounding may cost.
constexpr double LargestVolumeError = 1e-9;
}

//------------------------------------------------------------------------------
vtkProvenVisibilitySort::vtkProvenVisibilitySort()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkProvenVisibilitySort::~vtkProvenVisibilitySort() = default;

//------------------------------------------------------------------------------
void vtkProvenVisibilitySort::InitTraversal()
{
  Internals& internal = *this->Internal;
  internal.Next = 0;
  if (!this->Input || !this->Camera)
  {
    this->FailOnce(this->Input ? "No camera: call SetCamera." : "No input: call SetInput.");
    internal.Order = nullptr;
    internal.OrderedInput = nullptr;
    return;
  }
  if (!ViewEye::Find(this->Camera, this->InverseModelTransform, internal.Eye.data()))
  {
    this->FailOnce("The camera or the model transform is singular: there is no eye to sort for.");
    internal.Eye = { { 0.0, 0.0, 1.0, 0.0 } };
  }
  else
  {
    this->Internal->LastFailure.clear();
  }
  const MeshTime cells = MeshTimeOf(this->Input);
  const vtkMTimeType own = this->GetSettingsTime();
  if (internal.OrderedInput != this->Input || internal.OrderedCells != cells ||
      internal.OrderedSort != own || internal.OrderedEye != internal.Eye)
  {
    internal.Order = &this->SortCells(internal.Eye.data());
    if (ImaginaryGrid::HasImaginaryCells(this->Input))
    {
      internal.Filtered = *internal.Order;
      DropImaginary(this->Input, internal.Filtered);
      internal.Order = &internal.Filtered;
    }
    internal.Misordered = -1;
    internal.Groups = nullptr;
    internal.OrderedInput = this->Input;
    internal.OrderedCells = cells;
    internal.OrderedSort = own;
    internal.OrderedEye = internal.Eye;
  }
}

//------------------------------------------------------------------------------
void vtkProvenVisibilitySort::FailOnce(const std::string& text)
{
  if (this->Internal->LastFailure != text)
  {
    vtkErrorMacro(<< text);
  }
  this->Internal->LastFailure = text;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkProvenVisibilitySort::GetSettingsTime()
{
  // Camera, transform, direction and batch size are not among what a cache depends on.
  return this->SettingsTime.GetMTime();
}

//------------------------------------------------------------------------------
void vtkProvenVisibilitySort::SetConvexify(bool convexify)
{
  if (this->Convexify != convexify)
  {
    this->Convexify = convexify;
    this->SettingsTime.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkIdTypeArray* vtkProvenVisibilitySort::GetNextCells()
{
  Internals& internal = *this->Internal;
  const vtkIdType count = internal.Order ? static_cast<vtkIdType>(internal.Order->size()) : 0;
  const vtkIdType size = std::min<vtkIdType>(this->MaxCellsReturned, count - internal.Next);
  if (size <= 0)
  {
    return nullptr;
  }
  if (this->Direction == BACK_TO_FRONT)
  {
    // A window on the order: nothing is copied. It is not for the receiver to write to.
    internal.Batch->SetArray(
      const_cast<vtkIdType*>(internal.Order->data()) + internal.Next, size, 1);
  }
  else
  {
    internal.Reversed.assign(
      internal.Order->rbegin() + internal.Next, internal.Order->rbegin() + internal.Next + size);
    internal.Batch->SetArray(internal.Reversed.data(), size, 1);
  }
  internal.Next += size;
  return internal.Batch;
}

//------------------------------------------------------------------------------
void vtkProvenVisibilitySort::ForgetComplex()
{
  Internals& internal = *this->Internal;
  const MeshTime cells = MeshTimeOf(this->Input);
  if (internal.Built.Input == this->Input && internal.Built.Cells == cells)
  {
    return;
  }
  internal.Built.Input = this->Input;
  internal.Built.Cells = cells;
  internal.Built.HasComplex = false;
  internal.Built.HasImaginary = false;
}

//------------------------------------------------------------------------------
void vtkProvenVisibilitySort::TakeComplex(vtkProvenVisibilitySort* other)
{
  if (other && other != this && other->Input && other->Input == this->Input)
  {
    other->ForgetComplex();
    if (other->Internal->Built.HasComplex)
    {
      this->Internal->Built = std::move(other->Internal->Built);
      other->Internal->Built = Internals::Preparation();
      this->ComplexTime.Modified();
    }
  }
}

//------------------------------------------------------------------------------
const CellComplex& vtkProvenVisibilitySort::GetComplex()
{
  Internals& internal = *this->Internal;
  this->ForgetComplex();
  if (!internal.Built.HasComplex)
  {
    CellComplexReader::Read(this->Input, internal.Built.Complex);
    internal.Built.HasComplex = true;
    internal.Built.HasImaginary = false;
    internal.Built.Reported = false;
    this->ComplexTime.Modified();
  }
  return internal.Built.Complex;
}

//------------------------------------------------------------------------------
const ImaginaryCells& vtkProvenVisibilitySort::GetImaginaryCells()
{
  Internals& internal = *this->Internal;
  this->GetComplex();
  if (internal.Built.HasImaginary && internal.Built.Convexify == this->Convexify)
  {
    return internal.Built.Imaginary;
  }
  internal.Built.HasImaginary = true;
  internal.Built.Convexify = this->Convexify;
  internal.Built.IsFilled = false;
  internal.Built.VolumeError = 0.0;
  internal.Built.Imaginary = ImaginaryCells();
  this->ComplexTime.Modified();
  if (ImaginaryGrid::Take(this->Input, internal.Built.Complex, internal.Built.Imaginary))
  {
    internal.Built.IsFilled = true;
  }
  else if (this->Convexify)
  {
    ConvexificationResult result =
      Convexification::Run(internal.Built.Complex, ConvexificationSettings());
    internal.Built.VolumeError = result.VolumeError;
    internal.Built.IsFilled = result.VolumeError <= LargestVolumeError;
    internal.Built.Imaginary = std::move(result.Cells);
  }
  this->ReportComplex();
  return internal.Built.Imaginary;
}

//------------------------------------------------------------------------------
void vtkProvenVisibilitySort::ReportComplex()
{
  const CellComplex& complex = this->Internal->Built.Complex;
  if (!this->Internal->Built.Reported &&
      (!complex.IsComplex() || this->Internal->Built.VolumeError > LargestVolumeError))
  {
    vtkWarningMacro(
      "The cells are no complex: "
      << complex.NumberOfNonManifoldFaces << " faces are shared by more than two cells, "
      << complex.NumberOfOverlappingFaces << " by cells on the same side, "
      << complex.NumberOfNonconformingPairs << " pairs of cells touch in faces that do not match, "
      << "and " << 100.0 * this->Internal->Built.VolumeError
      << " % of the convex hull cannot be filled about them. They are sorted, but their order "
         "cannot be proven.");
  }
  this->Internal->Built.Reported = true;
}

//------------------------------------------------------------------------------
bool vtkProvenVisibilitySort::IsComplexConvex()
{
  this->GetImaginaryCells();
  return this->Internal->Built.IsFilled && this->Internal->Built.Complex.IsComplex();
}

//------------------------------------------------------------------------------
vtkCellArray* vtkProvenVisibilitySort::GetCyclicGroups()
{
  Internals& internal = *this->Internal;
  if (!internal.Groups)
  {
    std::vector<vtkIdType> cells, offsets;
    this->FindCyclicGroups(cells, offsets);
    internal.Groups = vtkSmartPointer<vtkCellArray>::New();
    for (size_t group = 0; group + 1 < offsets.size(); ++group)
    {
      internal.Groups->InsertNextCell(
        offsets[group + 1] - offsets[group], cells.data() + offsets[group]);
    }
  }
  return internal.Groups;
}

//------------------------------------------------------------------------------
void vtkProvenVisibilitySort::FindCyclicGroups(
  std::vector<vtkIdType>& cells, std::vector<vtkIdType>& offsets)
{
  cells.clear();
  offsets.assign(1, 0);
}

//------------------------------------------------------------------------------
vtkIdType vtkProvenVisibilitySort::GetNumberOfCycles()
{
  return this->GetCyclicGroups()->GetNumberOfCells();
}

//------------------------------------------------------------------------------
vtkIdType vtkProvenVisibilitySort::GetNumberOfMisorderedFaces()
{
  Internals& internal = *this->Internal;
  if (internal.Misordered < 0 && this->Input && internal.Order)
  {
    internal.Misordered =
      OrderProof::CountMisordered(this->GetComplex(), *internal.Order, internal.Eye.data());
  }
  return internal.Misordered;
}

//------------------------------------------------------------------------------
bool vtkProvenVisibilitySort::IsOrderProven()
{
  return this->Input && this->IsComplexConvex() && this->GetNumberOfCycles() == 0 &&
         this->GetNumberOfMisorderedFaces() == 0 && this->IsOrderRightAcrossGaps();
}

//------------------------------------------------------------------------------
bool vtkProvenVisibilitySort::IsOrderRightAcrossGaps()
{
  return this->GetImaginaryCells().GetNumberOfCells() == 0;
}

//------------------------------------------------------------------------------
void vtkProvenVisibilitySort::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Convexify: " << (this->Convexify ? "On" : "Off") << "\n";
}
