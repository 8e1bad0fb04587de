#include "BackToFrontOrder.h"

#include "CellProjectionFrame.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkProvenVisibilitySort.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

#include <algorithm>

namespace
{
// VTK's own mapper asks for cells in batches of this size.
constexpr int BatchSize = 1000;
}

//------------------------------------------------------------------------------
BackToFrontOrder::View BackToFrontOrder::TakeView(CellProjectionFrame& frame)
{
  vtkCamera* camera = frame.Renderer->GetActiveCamera();
  View view;
  std::copy_n(camera->GetModelViewTransformMatrix()->GetData(), 16, view.begin());
  std::copy_n(frame.Volume->GetMatrix()->GetData(), 16, view.begin() + 16);
  view[32] = camera->GetParallelProjection();
  return view;
}

//------------------------------------------------------------------------------
vtkVisibilitySort* BackToFrontOrder::Choose(
  vtkVisibilitySort* sort, vtkUnstructuredGrid* cells, vtkCamera* camera)
{
  return sort ? sort : this->Automatic.Choose(VisibilitySortChoice::Automatic, cells, camera, true);
}

//------------------------------------------------------------------------------
bool BackToFrontOrder::Update(
  vtkVisibilitySort* given, vtkUnstructuredGrid* cells, CellProjectionFrame& frame)
{
  vtkVisibilitySort* sort = this->Choose(given, cells, frame.Renderer->GetActiveCamera());
  const View view = TakeView(frame);
  if (sort == this->SeenSort && sort->GetMTime() == this->SeenSortTime &&
      cells->GetCells()->GetMTime() == this->SeenCells && view == this->SeenView)
  {
    return false;
  }
  sort->SetInput(cells);
  sort->SetDirectionToBackToFront();
  sort->SetModelTransform(frame.Volume->GetMatrix());
  sort->SetCamera(frame.Renderer->GetActiveCamera());
  sort->SetMaxCellsReturned(BatchSize);
  this->Collect(sort, cells->GetNumberOfCells());
  this->FindCyclicGroups(vtkProvenVisibilitySort::SafeDownCast(sort));
  this->SeenSort = sort;
  this->SeenSortTime = sort->GetMTime();
  this->SeenCells = cells->GetCells()->GetMTime();
  this->SeenView = view;
  return true;
}

//------------------------------------------------------------------------------
void BackToFrontOrder::Collect(vtkVisibilitySort* sort, vtkIdType numberOfCells)
{
  std::vector<unsigned char> seen(static_cast<size_t>(numberOfCells), 0);
  this->Cells.clear();
  this->Cells.reserve(seen.size());
  this->NumberOfWrongIds = 0;
  sort->InitTraversal();
  // A sort that never ends repeats itself.
  for (vtkIdTypeArray* batch = sort->GetNextCells();
       batch && this->NumberOfWrongIds <= numberOfCells; batch = sort->GetNextCells())
  {
    for (vtkIdType i = 0; i < batch->GetNumberOfTuples(); ++i)
    {
      const vtkIdType id = batch->GetValue(i);
      const bool good = id >= 0 && id < numberOfCells && !seen[id];
      this->NumberOfWrongIds += good ? 0 : 1;
      if (good)
      {
        seen[id] = 1;
        this->Cells.push_back(id);
      }
    }
  }
  for (vtkIdType id = 0; id < numberOfCells; ++id)
  {
    if (!seen[id])
    {
      ++this->NumberOfWrongIds;
      this->Cells.push_back(id);
    }
  }
}

//------------------------------------------------------------------------------
void BackToFrontOrder::FindCyclicGroups(vtkProvenVisibilitySort* sort)
{
  this->CyclicGroups.clear();
  vtkCellArray* groups = sort ? sort->GetCyclicGroups() : nullptr;
  if (!groups || groups->GetNumberOfCells() == 0)
  {
    return;
  }
  std::vector<vtkIdType> positions(this->Cells.size(), -1);
  for (size_t i = 0; i < this->Cells.size(); ++i)
  {
    positions[this->Cells[i]] = static_cast<vtkIdType>(i);
  }
  std::vector<Span> spans;
  vtkNew<vtkIdList> ids;
  for (vtkIdType group = 0; group < groups->GetNumberOfCells(); ++group)
  {
    groups->GetCellAtId(group, ids);
    Span span{ static_cast<vtkIdType>(positions.size()), 0 };
    for (const vtkIdType id : *ids)
    {
      const bool known = id >= 0 && id < static_cast<vtkIdType>(positions.size());
      span.Begin = known ? std::min(span.Begin, positions[id]) : span.Begin;
      span.End = known ? std::max(span.End, positions[id] + 1) : span.End;
    }
    spans.push_back(span);
  }
  this->KeepDisjoint(spans);
}

//------------------------------------------------------------------------------
void BackToFrontOrder::KeepDisjoint(std::vector<Span>& spans)
{
  std::sort(
    spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.Begin < b.Begin; });
  for (const Span& span : spans)
  {
    // Groups that are not contiguous interlock: what is resolved per pixel may as well be more.
    if (!this->CyclicGroups.empty() && span.Begin < this->CyclicGroups.back().End)
    {
      this->CyclicGroups.back().End = std::max(this->CyclicGroups.back().End, span.End);
    }
    else if (span.Begin < span.End)
    {
      this->CyclicGroups.push_back(span);
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType BackToFrontOrder::CountMisorderedFaces()
{
  auto* sort = vtkProvenVisibilitySort::SafeDownCast(this->SeenSort);
  return sort ? sort->GetNumberOfMisorderedFaces() : 0;
}
