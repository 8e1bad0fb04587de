#include "vtkBSPXMPVOVisibilitySort.h"

#include "BoundaryRelations.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBSPXMPVOVisibilitySort);

//------------------------------------------------------------------------------
vtkBSPXMPVOVisibilitySort::vtkBSPXMPVOVisibilitySort()
  : Relations(new BoundaryRelations)
{
  this->SetConvexify(false);
}

//------------------------------------------------------------------------------
vtkBSPXMPVOVisibilitySort::~vtkBSPXMPVOVisibilitySort() = default;

//------------------------------------------------------------------------------
const std::vector<vtkIdType>& vtkBSPXMPVOVisibilitySort::SortCells(const double eye[4])
{
  const CellComplex& complex = this->GetComplex();
  if (this->BuildTime.GetMTime() < this->ComplexTime.GetMTime())
  {
    this->Relations->Build(complex);
    this->BuildTime.Modified();
  }
  this->Relations->Sort(eye, this->Order);
  return this->Order;
}

//------------------------------------------------------------------------------
int vtkBSPXMPVOVisibilitySort::GetNumberOfLeftCells() const
{
  return this->Relations->GetNumberOfLeftCells();
}

//------------------------------------------------------------------------------
int vtkBSPXMPVOVisibilitySort::GetNumberOfAddedRelations() const
{
  return this->Relations->GetNumberOfAddedRelations();
}

//------------------------------------------------------------------------------
int vtkBSPXMPVOVisibilitySort::GetNumberOfFragments() const
{
  return static_cast<int>(this->Relations->GetTree().GetFragments().size());
}

//------------------------------------------------------------------------------
void vtkBSPXMPVOVisibilitySort::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfFragments: " << this->GetNumberOfFragments() << "\n";
  os << indent << "NumberOfAddedRelations: " << this->GetNumberOfAddedRelations() << "\n";
  os << indent << "NumberOfLeftCells: " << this->GetNumberOfLeftCells() << "\n";
}
