#include "vtkMPVOVisibilitySort.h"

#include "VisibilityGraph.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMPVOVisibilitySort);

/// The graph, and the complex that it was built from.
class vtkMPVOVisibilitySort::Internals
{
public:
  VisibilityGraph Graph;
  vtkMTimeType SeenComplex = 0;
};

//------------------------------------------------------------------------------
vtkMPVOVisibilitySort::vtkMPVOVisibilitySort()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkMPVOVisibilitySort::~vtkMPVOVisibilitySort() = default;

//------------------------------------------------------------------------------
const std::vector<vtkIdType>& vtkMPVOVisibilitySort::SortCells(const double eye[4])
{
  const ImaginaryCells& imaginary = this->GetImaginaryCells();
  if (this->Internal->SeenComplex != this->ComplexTime.GetMTime())
  {
    this->Internal->Graph.Build(this->GetComplex(), &imaginary);
    this->Internal->SeenComplex = this->ComplexTime.GetMTime();
  }
  if (this->Internal->Graph.Sort(eye, !this->IsComplexConvex()))
  {
    ++this->NumberOfSorts;
  }
  return this->Internal->Graph.GetOrder();
}

//------------------------------------------------------------------------------
void vtkMPVOVisibilitySort::FindCyclicGroups(
  std::vector<vtkIdType>& cells, std::vector<vtkIdType>& offsets)
{
  cells = this->Internal->Graph.GetGroupCells();
  offsets = this->Internal->Graph.GetGroupOffsets();
}

//------------------------------------------------------------------------------
bool vtkMPVOVisibilitySort::IsOrderRightAcrossGaps()
{
  // The sort runs through the imaginary cells, and what no order satisfies is a group.
  return true;
}

//------------------------------------------------------------------------------
void vtkMPVOVisibilitySort::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSorts: " << this->NumberOfSorts << "\n";
}
