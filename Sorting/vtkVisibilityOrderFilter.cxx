#include "vtkVisibilityOrderFilter.h"

#include "VTKVersions.h"
#include "VisibilitySortChoice.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkVisibilityOrderFilter);

namespace
{
vtkSmartPointer<vtkIdTypeArray> NewCellArray(const char* name, vtkIdType cells)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(cells);
  array->FillValue(-1);
  return array;
}

// Ranks in the order that the sort gives, then those of the cells it leaves out.
void FillRanks(vtkVisibilitySort* sort, vtkIdTypeArray* ranks)
{
  vtkIdType rank = 0;
  sort->InitTraversal();
  while (vtkIdTypeArray* batch = sort->GetNextCells())
  {
    for (vtkIdType i = 0; i < batch->GetNumberOfValues(); ++i)
    {
      ranks->SetValue(batch->GetValue(i), rank++);
    }
  }
  for (vtkIdType cell = 0; cell < ranks->GetNumberOfValues(); ++cell)
  {
    if (ranks->GetValue(cell) < 0)
    {
      ranks->SetValue(cell, rank++);
    }
  }
}

void FillGroups(vtkCellArray* groups, vtkIdTypeArray* groupOfCell)
{
  vtkNew<vtkIdList> cells;
  for (vtkIdType group = 0; group < groups->GetNumberOfCells(); ++group)
  {
    groups->GetCellAtId(group, cells);
    for (vtkIdType i = 0; i < cells->GetNumberOfIds(); ++i)
    {
      groupOfCell->SetValue(cells->GetId(i), group);
    }
  }
}
}

class vtkVisibilityOrderFilter::Internals
{
public:
  /** The user's camera, or one at infinity; null where the direction has no length. */
  vtkCamera* FindCamera(const double direction[3])
  {
    if (this->Camera)
    {
      return this->Camera;
    }
    double forward[3] = { direction[0], direction[1], direction[2] };
    double up[3];
    if (!(vtkMath::Normalize(forward) > 0.0))
    {
      return nullptr;
    }
    vtkMath::Perpendiculars(forward, up, nullptr, 0.0);
    this->Parallel->ParallelProjectionOn();
    this->Parallel->SetFocalPoint(0.0, 0.0, 0.0);
    this->Parallel->SetPosition(-forward[0], -forward[1], -forward[2]);
    this->Parallel->SetViewUp(up);
    return this->Parallel;
  }

  vtkSmartPointer<vtkCamera> Camera;
  vtkNew<vtkCamera> Parallel;
  VisibilitySortChoice Choice;
  bool HasOrder = false;
};

//------------------------------------------------------------------------------
vtkVisibilityOrderFilter::vtkVisibilityOrderFilter()
  : Internal(new Internals)
{
}

vtkVisibilityOrderFilter::~vtkVisibilityOrderFilter() = default;

//------------------------------------------------------------------------------
void vtkVisibilityOrderFilter::SetCamera(vtkCamera* camera)
{
  if (camera != this->Internal->Camera)
  {
    this->Internal->Camera = camera;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkVisibilityOrderFilter::GetCamera()
{
  return this->Internal->Camera;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVisibilityOrderFilter::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  vtkCamera* camera = this->Internal->Camera;
  return camera ? std::max(time, camera->GetMTime()) : time;
}

//------------------------------------------------------------------------------
int vtkVisibilityOrderFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
int vtkVisibilityOrderFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  vtkCamera* camera = this->Internal->FindCamera(this->Direction);
  this->Internal->HasOrder = false;
  if (!input || !output || !camera)
  {
    vtkErrorMacro("No order: " << (camera ? "the input is no vtkUnstructuredGrid."
                                          : "Direction has no length; set one, or a camera."));
    return 0;
  }
  output->ShallowCopy(input);
  const vtkIdType cells = input->GetNumberOfCells();
  auto ranks = NewCellArray("VisibilityOrder", cells);
  VisibilitySortChoice& choice = this->Internal->Choice;
  if (cells > 0 && !IsAborted(this))
  {
    FillRanks(choice.Choose(this->SortMethod, input, camera, this->Convexify), ranks);
    this->Internal->HasOrder = true;
  }
  output->GetCellData()->AddArray(ranks);
  if (this->SortMethod == MPVOC)
  {
    auto groups = NewCellArray("CyclicGroup", cells);
    if (this->Internal->HasOrder)
    {
      FillGroups(choice.GetProvenSort()->GetCyclicGroups(), groups);
    }
    output->GetCellData()->AddArray(groups);
  }
  this->UpdateProgress(1.0);
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkVisibilityOrderFilter::GetSortMethodUsed()
{
  return this->Internal->HasOrder ? this->Internal->Choice.GetName() : "";
}

//------------------------------------------------------------------------------
vtkIdType vtkVisibilityOrderFilter::GetNumberOfCycles()
{
  auto* sort = this->Internal->Choice.GetProvenSort();
  return this->Internal->HasOrder && sort ? sort->GetNumberOfCycles() : -1;
}

//------------------------------------------------------------------------------
vtkIdType vtkVisibilityOrderFilter::GetNumberOfMisorderedFaces()
{
  auto* sort = this->Internal->Choice.GetProvenSort();
  return this->Internal->HasOrder && sort ? sort->GetNumberOfMisorderedFaces() : -1;
}

//------------------------------------------------------------------------------
bool vtkVisibilityOrderFilter::IsOrderProven()
{
  auto* sort = this->Internal->Choice.GetProvenSort();
  return this->Internal->HasOrder && sort && sort->IsOrderProven();
}

//------------------------------------------------------------------------------
void vtkVisibilityOrderFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SortMethod: " << this->SortMethod << "\n"
     << indent << "SortMethodUsed: " << this->GetSortMethodUsed() << "\n"
     << indent << "Camera: " << this->Internal->Camera.Get() << "\n"
     << indent << "Direction: " << this->Direction[0] << " " << this->Direction[1] << " "
     << this->Direction[2] << "\n"
     << indent << "Convexify: " << (this->Convexify ? "On" : "Off") << "\n";
}
