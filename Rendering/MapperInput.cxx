#include "MapperInput.h"

#include "ScalarChoice.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkConvexCells.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{
// vtkAppendFilter keeps what all blocks have: one that has no ghosts says so.
void AddGhosts(vtkDataSetAttributes* data, vtkIdType count)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  if (!data->GetArray(name))
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(name);
    ghosts->SetNumberOfValues(count);
    ghosts->FillValue(0);
    data->AddArray(ghosts);
  }
}
}

//------------------------------------------------------------------------------
vtkUnstructuredGridBase* MapperInput::Take(vtkDataObject* input, vtkAbstractVolumeMapper* mapper)
{
  if (auto* grid = vtkUnstructuredGridBase::SafeDownCast(input))
  {
    this->LeftOut.clear();
    this->Grid = nullptr;
    return grid;
  }
  this->ListBlocks(input);
  std::vector<vtkMTimeType> sources = this->FindSources(mapper);
  if (!this->Grid || sources != this->Sources)
  {
    this->Sources = std::move(sources);
    this->LeaveOthersOut(mapper);
    this->Append();
  }
  return this->Grid;
}

//------------------------------------------------------------------------------
void MapperInput::ListBlocks(vtkDataObject* input)
{
  this->Blocks.clear();
  if (auto* data = vtkDataSet::SafeDownCast(input))
  {
    this->Blocks.push_back({ data, "the input" });
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return;
  }
  auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    const char* name = iterator->HasCurrentMetaData()
                         ? iterator->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
                         : nullptr;
    auto* data = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    this->Blocks.push_back(
      { data, name ? name : "number " + std::to_string(iterator->GetCurrentFlatIndex()) });
  }
}

//------------------------------------------------------------------------------
std::vector<vtkMTimeType> MapperInput::FindSources(vtkAbstractVolumeMapper* mapper) const
{
  std::vector<vtkMTimeType> sources = { mapper->GetMTime() };
  for (const Block& block : this->Blocks)
  {
    sources.push_back(block.Data ? block.Data->GetMTime() : 0);
  }
  return sources;
}

//------------------------------------------------------------------------------
void MapperInput::LeaveOthersOut(vtkAbstractVolumeMapper* mapper)
{
  vtkNew<vtkUnstructuredGrid> nothing;
  vtkDataArray* first = nullptr;
  std::vector<Block> kept;
  std::string others;
  vtkIdType count = 0;
  for (const Block& block : this->Blocks)
  {
    const bool empty = !block.Data || block.Data->GetNumberOfCells() == 0;
    const ScalarChoice choice(mapper, empty ? nothing.Get() : block.Data);
    vtkDataArray* array = empty ? nullptr : choice.Array;
    const bool fits = array && (!first || (choice.OnePerCell == this->OnePerCell &&
                                            array->GetDataType() == first->GetDataType() &&
                                            array->GetNumberOfComponents() ==
                                              first->GetNumberOfComponents()));
    if (fits)
    {
      first = first ? first : array;
      this->OnePerCell = choice.OnePerCell;
      kept.push_back(block);
      continue;
    }
    ++count;
    const std::string why = empty ? "no cells" : array ? "another type of array" : choice.Problem;
    others += (others.empty() ? "" : ", ") + block.Name + " (" + why + ")";
  }
  this->Scalars = first && first->GetName() ? first->GetName() : "";
  this->LeftOut = count > 0 && !kept.empty()
                    ? std::to_string(count) + " of " + std::to_string(this->Blocks.size()) +
                        " blocks are left out: " + others + ". The rest is drawn."
                    : "";
  // Where none fits, all of them are to say so.
  this->Blocks = kept.empty() ? this->Blocks : kept;
}

//------------------------------------------------------------------------------
void MapperInput::Append()
{
  const auto hasGhosts = [](bool ofCells)
  {
    return [ofCells](const Block& block)
    {
      vtkDataSet* data = block.Data;
      return data && (ofCells ? data->GetCellGhostArray() : data->GetPointGhostArray());
    };
  };
  const bool cellGhosts = std::any_of(this->Blocks.begin(), this->Blocks.end(), hasGhosts(true));
  const bool pointGhosts = std::any_of(this->Blocks.begin(), this->Blocks.end(), hasGhosts(false));
  vtkNew<vtkAppendFilter> append;
  for (const Block& block : this->Blocks)
  {
    if (block.Data)
    {
      auto copy = vtk::TakeSmartPointer(block.Data->NewInstance());
      copy->ShallowCopy(block.Data);
      if (cellGhosts)
      {
        AddGhosts(copy->GetCellData(), copy->GetNumberOfCells());
      }
      if (pointGhosts)
      {
        AddGhosts(copy->GetPointData(), copy->GetNumberOfPoints());
      }
      append->AddInputData(copy);
    }
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
    grid->ShallowCopy(append->GetOutput());
  }
  vtkDataSetAttributes* data = grid->GetPointData();
  data = this->OnePerCell ? static_cast<vtkDataSetAttributes*>(grid->GetCellData()) : data;
  if (!this->Scalars.empty())
  {
    data->SetActiveScalars(this->Scalars.c_str());
  }
  this->Grid = grid;
}

//------------------------------------------------------------------------------
void MapperInput::Feed(
  vtkUnstructuredGridBase* mesh, vtkAbstractVolumeMapper* mapper, vtkConvexCells* cells)
{
  const ScalarChoice choice(mapper, mesh);
  cells->SetInputData(mesh);
  if (choice.Array && choice.Array->GetName() && !choice.OnePerCell)
  {
    cells->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, choice.Array->GetName());
  }
}

//------------------------------------------------------------------------------
void MapperInput::FindBounds(vtkDataObject* input, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  if (auto* data = vtkDataSet::SafeDownCast(input))
  {
    data->GetBounds(bounds);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    composite->GetBounds(bounds);
  }
}
