#include "vtkProvenVisibilitySort.h"
#include "CellComplex.h"
#include "Convexification.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
class vtkProvenVisibilitySort::Internals
{
public:
  std::vector<vtkIdType> Order;
  vtkNew<vtkIdTypeArray> Batch;
  vtkNew<vtkCellArray> Groups;
  size_t Next = 0;
};
vtkProvenVisibilitySort::vtkProvenVisibilitySort()
  : Internal(new Internals)
{
}
vtkProvenVisibilitySort::~vtkProvenVisibilitySort() = default;
void vtkProvenVisibilitySort::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
void vtkProvenVisibilitySort::InitTraversal()
{
  double eye[4] = { 0, 0, 0, 1 };
  this->Camera->GetPosition(eye);
  this->InverseModelTransform->MultiplyPoint(eye, eye);
  this->Internal->Next = 0;
  this->Internal->Order.clear();
  this->SortCells(eye, this->Internal->Order);
}
vtkIdTypeArray* vtkProvenVisibilitySort::GetNextCells()
{
  auto& in = *this->Internal;
  if (in.Next >= in.Order.size())
    return nullptr;
  in.Batch->Reset();
  for (int i = 0; i < this->MaxCellsReturned && in.Next < in.Order.size(); ++i)
    in.Batch->InsertNextValue(in.Order[in.Next++]);
  return in.Batch;
}
vtkIdType vtkProvenVisibilitySort::GetNumberOfCycles()
{
  return GetCyclicGroups()->GetNumberOfCells();
}
vtkCellArray* vtkProvenVisibilitySort::GetCyclicGroups()
{
  std::vector<vtkIdType> cells, offsets;
  this->FindCyclicGroups(cells, offsets);
  this->Internal->Groups->Initialize();
  for (size_t i = 0; i + 1 < offsets.size(); ++i)
    this->Internal->Groups->InsertNextCell(offsets[i + 1] - offsets[i], cells.data() + offsets[i]);
  return this->Internal->Groups;
}
vtkIdType vtkProvenVisibilitySort::GetNumberOfMisorderedFaces()
{
  return 0;
}
bool vtkProvenVisibilitySort::IsOrderProven()
{
  return false;
}
void vtkProvenVisibilitySort::FindCyclicGroups(std::vector<vtkIdType>&, std::vector<vtkIdType>&) {}
