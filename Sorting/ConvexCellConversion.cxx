#include "ConvexCellConversion.h"

#include "CarriedData.h"
#include "CoincidentPoints.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
using TetrahedralSplit::Shape;

constexpr vtkIdType BlockSize = 4096;
// In place of a point's canonical id.
constexpr vtkIdType NonFinitePoint = -1;
constexpr vtkIdType HiddenPoint = -2;
constexpr char ImaginaryArrayName[] = "Imaginary";

bool ShapeOf(int cellType, Shape& shape)
{
  switch (cellType)
  {
    case VTK_TETRA:
      shape = Shape::Tetrahedron;
      return true;
    case VTK_PYRAMID:
      shape = Shape::Pyramid;
      return true;
    case VTK_WEDGE:
      shape = Shape::Wedge;
      return true;
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      shape = Shape::Hexahedron;
      return true;
    default:
      return false;
  }
}

// Null where there is none that fits.
const unsigned char* Bytes(vtkDataSetAttributes* data, const char* name, vtkIdType count)
{
  auto* array = vtkUnsignedCharArray::SafeDownCast(data->GetArray(name));
  const bool fits = array && array->GetNumberOfValues() == count;
  return fits && count > 0 ? array->GetPointer(0) : nullptr;
}

const unsigned char* GhostBits(vtkDataSetAttributes* data, vtkIdType count)
{
  return Bytes(data, vtkDataSetAttributes::GhostArrayName(), count);
}
}

ConvexCellConversion::ConvexCellConversion(vtkUnstructuredGridBase* input, bool tetrahedraOnly)
  : Input(input)
  , TetrahedraOnly(tetrahedraOnly)
  , NumberOfPoints(input->GetNumberOfPoints())
  , NumberOfCells(input->GetNumberOfCells())
  , Points(input->GetPoints() ? input->GetPoints()->GetData() : nullptr)
  , GhostCells(GhostBits(input->GetCellData(), input->GetNumberOfCells()))
  , ImaginaryCells(Bytes(input->GetCellData(), ImaginaryArrayName, input->GetNumberOfCells()))
{
}

ConvexCellConversion::~ConvexCellConversion() = default;

vtkIdType ConvexCellConversion::GetNumberOfBlocks() const
{
  return (this->NumberOfCells + BlockSize - 1) / BlockSize;
}

void ConvexCellConversion::ReadCells()
{
  this->Types.resize(this->NumberOfCells);
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(this->Input))
  {
    this->Cells = grid->GetCells();
    vtkSMPTools::For(0, this->NumberOfCells,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType cell = begin; cell < end; ++cell)
        {
          this->Types[cell] = static_cast<unsigned char>(grid->GetCellType(cell));
        }
      });
    return;
  }
  // Other implementations promise nothing to threads.
  this->Cells = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdList> list;
  for (vtkIdType cell = 0; cell < this->NumberOfCells; ++cell)
  {
    this->Types[cell] = static_cast<unsigned char>(this->Input->GetCellType(cell));
    this->Input->GetCellPoints(cell, list);
    this->Cells->InsertNextCell(list);
  }
}

void ConvexCellConversion::MergePoints()
{
  const unsigned char* ghosts = GhostBits(this->Input->GetPointData(), this->NumberOfPoints);
  this->Canonical.resize(this->NumberOfPoints);
  vtkSMPTools::For(0, this->NumberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      double x[3];
      for (vtkIdType point = begin; point < end; ++point)
      {
        this->Points.Get(point, x);
        const bool finite = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
        const bool hidden = ghosts && (ghosts[point] & vtkDataSetAttributes::HIDDENPOINT);
        this->Canonical[point] = hidden ? HiddenPoint : finite ? 0 : NonFinitePoint;
      }
    });
  CoincidentPoints::Merge(this->Points, this->NumberOfPoints, this->Canonical.data());
  this->NumberOutputPoints();
}

void ConvexCellConversion::NumberOutputPoints()
{
  vtkIdType removed = 0;
  for (vtkIdType point = 0; point < this->NumberOfPoints; ++point)
  {
    removed += this->Canonical[point] < 0;
    this->NumberOfMergedPoints += this->Canonical[point] >= 0 && this->Canonical[point] != point;
  }
  removed += this->NumberOfMergedPoints;
  if (removed == 0)
  {
    return;
  }
  this->OutputIds.assign(this->NumberOfPoints, -1);
  this->SourcePoints.reserve(this->NumberOfPoints - removed);
  for (vtkIdType point = 0; point < this->NumberOfPoints; ++point)
  {
    if (this->Canonical[point] == point)
    {
      this->OutputIds[point] = static_cast<vtkIdType>(this->SourcePoints.size());
      this->SourcePoints.push_back(point);
    }
  }
}

// visit(cell, list, block) for the cells of each block in order; the blocks in parallel.
template <typename Visit>
void ConvexCellConversion::VisitBlocks(vtkIdType begin, vtkIdType end, Visit visit)
{
  vtkSMPTools::For(begin, end, 1,
    [&](vtkIdType firstBlock, vtkIdType lastBlock)
    {
      vtkNew<vtkIdList> list;
      for (vtkIdType block = firstBlock; block < lastBlock; ++block)
      {
        const vtkIdType last = std::min((block + 1) * BlockSize, this->NumberOfCells);
        visit(block, block * BlockSize, last, list.Get());
      }
    });
}

// Canonical ids in the shape's order. False where the cell is not one of this mesh.
bool ConvexCellConversion::ReadIds(
  vtkIdType cell, Shape shape, vtkIdList* list, vtkIdType* ids) const
{
  const int count = TetrahedralSplit::NumberOfVertices(shape);
  this->Cells->GetCellAtId(cell, list);
  if (list->GetNumberOfIds() != count)
  {
    return false;
  }
  for (int i = 0; i < count; ++i)
  {
    const vtkIdType id = list->GetId(i);
    if (id < 0 || id >= this->NumberOfPoints)
    {
      return false;
    }
    ids[i] = this->Canonical[id];
  }
  if (this->Types[cell] == VTK_VOXEL)
  {
    std::swap(ids[2], ids[3]);
    std::swap(ids[6], ids[7]);
  }
  return true;
}

ConvexCellPlan ConvexCellConversion::PlanCell(vtkIdType cell, vtkIdList* list) const
{
  constexpr int ghostBits = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  ConvexCellPlan plan;
  Shape shape;
  vtkIdType ids[TetrahedralSplit::MaximumVertices];
  if (this->ImaginaryCells && this->ImaginaryCells[cell] == 1)
  {
    plan.Fate = ConvexCellPlan::Imaginary;
    return plan;
  }
  if (this->GhostCells && (this->GhostCells[cell] & ghostBits))
  {
    plan.Fate = ConvexCellPlan::Ghost;
    return plan;
  }
  if (!ShapeOf(this->Types[cell], shape))
  {
    plan.Fate = ConvexCellPlan::OtherType;
    return plan;
  }
  if (!this->ReadIds(cell, shape, list, ids))
  {
    return plan;
  }
  const int count = TetrahedralSplit::NumberOfVertices(shape);
  const vtkIdType smallest = *std::min_element(ids, ids + count);
  if (smallest < 0)
  {
    plan.Fate = smallest == HiddenPoint ? ConvexCellPlan::Ghost : ConvexCellPlan::NonFinite;
    return plan;
  }
  double points[TetrahedralSplit::MaximumVertices][3];
  for (int i = 0; i < count; ++i)
  {
    this->Points.Get(ids[i], points[i]);
  }
  return PlanConvexCell(shape, ids, points, this->TetrahedraOnly);
}

void ConvexCellConversion::PlanBlocks(vtkIdType begin, vtkIdType end)
{
  this->Plans.resize(this->NumberOfCells);
  this->BlockStarts.resize(this->GetNumberOfBlocks() + 1);
  this->VisitBlocks(begin, end,
    [this](vtkIdType block, vtkIdType first, vtkIdType last, vtkIdList* list)
    {
      ConvexCellCursor size;
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        this->Plans[cell] = this->PlanCell(cell, list);
        Shape shape = Shape::Tetrahedron;
        ShapeOf(this->Types[cell], shape);
        SkipConvexCell(this->Plans[cell], shape, size);
      }
      this->BlockStarts[block + 1] = size;
    });
}

void ConvexCellConversion::AllocateCells()
{
  this->BlockStarts.resize(this->GetNumberOfBlocks() + 1);
  for (std::size_t block = 1; block < this->BlockStarts.size(); ++block)
  {
    this->BlockStarts[block].Cell += this->BlockStarts[block - 1].Cell;
    this->BlockStarts[block].Id += this->BlockStarts[block - 1].Id;
  }
  const ConvexCellCursor end = this->BlockStarts.back();
  this->OutputTypes->SetNumberOfValues(end.Cell);
  this->Offsets->SetNumberOfValues(end.Cell + 1);
  this->Offsets->SetValue(end.Cell, end.Id);
  this->Ids->SetNumberOfValues(end.Id);
  this->SourceCells->SetName("SourceCell");
  this->SourceCells->SetNumberOfValues(end.Cell);
}

void ConvexCellConversion::WriteBlocks(vtkIdType begin, vtkIdType end)
{
  const ConvexCellArrays arrays = { this->OutputTypes->GetPointer(0), this->Offsets->GetPointer(0),
    this->Ids->GetPointer(0), this->SourceCells->GetPointer(0) };
  const vtkIdType* outputIds = this->OutputIds.empty() ? nullptr : this->OutputIds.data();
  this->VisitBlocks(begin, end,
    [&](vtkIdType block, vtkIdType first, vtkIdType last, vtkIdList* list)
    {
      ConvexCellCursor cursor = this->BlockStarts[block];
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        const ConvexCellPlan& plan = this->Plans[cell];
        Shape shape;
        vtkIdType ids[TetrahedralSplit::MaximumVertices];
        if (plan.Fate <= ConvexCellPlan::Tetrahedra && ShapeOf(this->Types[cell], shape) &&
            this->ReadIds(cell, shape, list, ids))
        {
          WriteConvexCell(plan, shape, ids, outputIds, cell, arrays, cursor);
        }
      }
    });
}

void ConvexCellConversion::FillOutput(vtkUnstructuredGrid* output)
{
  this->FillPoints(output);
  if (this->OutputCells->GetNumberOfCells() == 0)
  {
    this->OutputCells->SetData(this->Offsets, this->Ids);
  }
  output->SetCells(this->OutputTypes, this->OutputCells);
  this->FillCellData(output);
}

void ConvexCellConversion::FillPoints(vtkUnstructuredGrid* output)
{
  if (this->OutputIds.empty())
  {
    output->SetPoints(this->Input->GetPoints());
    output->GetPointData()->PassData(
      CarriedData::WholeArrays(this->Input->GetPointData(), this->Input->GetNumberOfPoints()));
    return;
  }
  const auto count = static_cast<vtkIdType>(this->SourcePoints.size());
  if (!this->OutputPoints)
  {
    this->OutputPoints = vtkSmartPointer<vtkPoints>::New();
    this->OutputPoints->SetDataType(this->Input->GetPoints()->GetDataType());
    this->OutputPoints->SetNumberOfPoints(count);
    vtkNew<vtkIdList> list;
    list->SetNumberOfIds(count);
    std::copy(this->SourcePoints.begin(), this->SourcePoints.end(), list->GetPointer(0));
    this->Input->GetPoints()->GetData()->GetTuples(list, this->OutputPoints->GetData());
  }
  output->SetPoints(this->OutputPoints);
  CarriedData::CopyTuples(
    CarriedData::WholeArrays(this->Input->GetPointData(), this->Input->GetNumberOfPoints()),
    output->GetPointData(), this->SourcePoints.data(), count);
}

void ConvexCellConversion::FillCellData(vtkUnstructuredGrid* output) const
{
  vtkCellData* data = output->GetCellData();
  const auto fateIs = [](ConvexCellPlan::FateType fate)
  { return [fate](const ConvexCellPlan& plan) { return plan.Fate == fate; }; };
  const auto& plans = this->Plans;
  if (std::all_of(plans.begin(), plans.end(), fateIs(ConvexCellPlan::Whole)))
  {
    data->PassData(
      CarriedData::WholeArrays(this->Input->GetCellData(), this->Input->GetNumberOfCells()));
  }
  else
  {
    CarriedData::CopyTuples(
      CarriedData::WholeArrays(this->Input->GetCellData(), this->Input->GetNumberOfCells()), data,
      this->SourceCells->GetPointer(0), this->SourceCells->GetNumberOfValues());
  }
  if (std::any_of(plans.begin(), plans.end(), fateIs(ConvexCellPlan::Tetrahedra)))
  {
    data->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  }
  if (std::any_of(plans.begin(), plans.end(), fateIs(ConvexCellPlan::Imaginary)))
  {
    data->RemoveArray(ImaginaryArrayName);
  }
  data->AddArray(this->SourceCells);
}

ConvexCellCounts ConvexCellConversion::Count() const
{
  ConvexCellCounts counts = CountConvexCells(this->Plans, this->Types);
  counts.MergedPoints = this->NumberOfMergedPoints;
  return counts;
}

void ConvexCellConversion::ReleaseWorkingMemory()
{
  this->Cells = nullptr;
  std::vector<vtkIdType>().swap(this->Canonical);
  std::vector<ConvexCellCursor>().swap(this->BlockStarts);
}

bool ConvexCellConversion::HasSameTypes(vtkUnstructuredGridBase* input) const
{
  bool same = input->GetNumberOfCells() == this->NumberOfCells;
  for (vtkIdType cell = 0; same && cell < this->NumberOfCells; ++cell)
  {
    same = this->Types[cell] == static_cast<unsigned char>(input->GetCellType(cell));
  }
  return same;
}
