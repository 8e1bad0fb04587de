#include "VisibilitySortChoice.h"

#include "MeshTime.h"
#include "vtkMPVOVisibilitySort.h"
#include "vtkPowerVisibilitySort.h"

#include "vtkCamera.h"
#include "vtkCellCenterDepthSort.h"

//------------------------------------------------------------------------------
vtkVisibilitySort* VisibilitySortChoice::Choose(
  int method, vtkDataSet* input, vtkCamera* camera, bool convexify)
{
  constexpr const char* names[] = { "", "MPVO", "MPVOC", "Power", "CellCenter" };
  const int resolved = this->Resolve(method, input, convexify);
  this->Name = names[resolved];
  this->Make(resolved);
  if (auto* proven = this->GetProvenSort())
  {
    proven->SetConvexify(convexify);
  }
  this->Sort->SetInput(input);
  this->Sort->SetCamera(camera);
  if (auto* proven = this->GetProvenSort())
  {
    proven->TakeComplex(this->InexactPower);
  }
  this->InexactPower = nullptr;
  return this->Sort;
}

//------------------------------------------------------------------------------
int VisibilitySortChoice::Resolve(int method, vtkDataSet* input, bool convexify)
{
  if (method != Automatic || !convexify)
  {
    return method == Automatic ? int(MPVO) : method;
  }
  const MeshTime time = MeshTimeOf(input);
  if (input != this->SeenInput || time != this->SeenTime)
  {
    this->SeenInput = input;
    this->SeenTime = time;
    auto power = vtkSmartPointer<vtkPowerVisibilitySort>::New();
    power->SetInput(input);
    const bool exact = power->IsExact();
    this->ExactPower = exact ? power : nullptr;
    this->InexactPower = exact ? nullptr : power;
  }
  return this->ExactPower ? Power : MPVO;
}

//------------------------------------------------------------------------------
void VisibilitySortChoice::Make(int method)
{
  if (method == Power && this->ExactPower)
  {
    this->Sort = this->ExactPower;
    this->Made = Power;
    return;
  }
  const auto kind = [](int which) { return which == MPVOC ? int(MPVO) : which; };
  if (this->Sort && kind(this->Made) == kind(method))
  {
    return;
  }
  this->Made = method;
  if (method == Power)
  {
    this->Sort = vtkSmartPointer<vtkPowerVisibilitySort>::New();
  }
  else if (method == CellCenter)
  {
    this->Sort = vtkSmartPointer<vtkCellCenterDepthSort>::New();
  }
  else
  {
    this->Sort = vtkSmartPointer<vtkMPVOVisibilitySort>::New();
  }
}

//------------------------------------------------------------------------------
vtkProvenVisibilitySort* VisibilitySortChoice::GetProvenSort() const
{
  return vtkProvenVisibilitySort::SafeDownCast(this->Sort);
}
