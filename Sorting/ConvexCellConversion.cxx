#include "ConvexCellConversion.h"

#include "CarriedData.h"
#include "CoincidentPoints.h"
#include "ConvexCellGrid.h"
#include "PolyhedronPlan.h"

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
#include <array>
#include <cmath>

namespace
{
using TetrahedralSplit::Shape;

constexpr vtkIdType BlockSize = 4096;
// In place of a point's canonical id.
constexpr vtkIdType NonFinitePoint = -1;
constexpr vtkIdType HiddenPoint = -2;

// Null where there is none that fits.
const unsigned char* GhostBits(vtkDataSetAttributes* data, vtkIdType count)
{
  auto* array =
    vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const bool fits = array && array->GetNumberOfValues() == count;
  return fits && count > 0 ? array->GetPointer(0) : nullptr;
}

// Whole where all points can be drawn.
ConvexCellPlan::FateType FateOfPoints(const vtkIdType* ids, vtkIdType count)
{
  const vtkIdType smallest = count > 0 ? *std::min_element(ids, ids + count) : 0;
  return smallest == HiddenPoint      ? ConvexCellPlan::Ghost
         : smallest == NonFinitePoint ? ConvexCellPlan::NonFinite
                                      : ConvexCellPlan::Whole;
}
}

/** What one thread reads a cell into. */
struct ConvexCellConversion::Scratch
{
  vtkNew<vtkIdList> List;
  PolyhedronSurface Surface;
  std::vector<std::array<double, 3>> Points;
  vtkIdType Ids[TetrahedralSplit::MaximumVertices];
};

ConvexCellConversion::ConvexCellConversion(vtkUnstructuredGridBase* input, bool tetrahedraOnly)
  : Input(input)
  , TetrahedraOnly(tetrahedraOnly)
  , NumberOfPoints(input->GetNumberOfPoints())
  , NumberOfCells(input->GetNumberOfCells())
  , Points(input->GetPoints() ? input->GetPoints()->GetData() : nullptr)
  , Reader(input)
{
}

ConvexCellConversion::~ConvexCellConversion() = default;

vtkIdType ConvexCellConversion::GetNumberOfBlocks() const
{
  return (this->NumberOfCells + BlockSize - 1) / BlockSize;
}

void ConvexCellConversion::ReadCells()
{
  this->Reader.Open();
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

// visit(block, first cell, end of cells, scratch); the blocks in parallel.
template <typename Visit>
void ConvexCellConversion::VisitBlocks(vtkIdType begin, vtkIdType end, Visit visit)
{
  vtkSMPTools::For(begin, end, 1,
    [&](vtkIdType firstBlock, vtkIdType lastBlock)
    {
      Scratch scratch;
      for (vtkIdType block = firstBlock; block < lastBlock; ++block)
      {
        const vtkIdType last = std::min((block + 1) * BlockSize, this->NumberOfCells);
        visit(block, block * BlockSize, last, scratch);
      }
    });
}

ConvexCellConversion::Coordinates* ConvexCellConversion::FetchPoints(
  const vtkIdType* ids, int count, Scratch& scratch) const
{
  scratch.Points.resize(count);
  for (int i = 0; i < count; ++i)
  {
    this->Points.Get(ids[i], scratch.Points[i].data());
  }
  return reinterpret_cast<Coordinates*>(scratch.Points.data());
}

ConvexCellCut ConvexCellConversion::FindCut(int type) const
{
  if (this->TetrahedraOnly)
  {
    return ConvexCellCut::All;
  }
  const bool isConvex = type == VTK_TETRA || type == VTK_VOXEL;
  return isConvex ? ConvexCellCut::None : ConvexCellCut::NonConvex;
}

// Moves the cursor past what will be written.
ConvexCellPlan ConvexCellConversion::PlanCell(
  vtkIdType cell, Scratch& scratch, ConvexCellCursor& cursor) const
{
  ConvexCellPlan plan;
  Shape shape;
  const int type = this->Reader.GetTypes()[cell];
  plan.Fate = this->Reader.Refuse(cell);
  if (plan.Fate != ConvexCellPlan::Whole)
  {
    return plan;
  }
  if (type == VTK_POLYHEDRON)
  {
    return this->PlanPolyhedronCell(cell, scratch, cursor);
  }
  if (!ConvexCellReader::ShapeOf(type, shape))
  {
    plan.Fate = ConvexCellPlan::OtherType;
    return plan;
  }
  if (!this->Reader.ReadIds(cell, shape, this->Canonical, scratch.List, scratch.Ids))
  {
    plan.Fate = ConvexCellPlan::Invalid;
    return plan;
  }
  const int count = TetrahedralSplit::NumberOfVertices(shape);
  plan.Fate = FateOfPoints(scratch.Ids, count);
  if (plan.Fate == ConvexCellPlan::Whole)
  {
    plan = PlanConvexCell(
      shape, scratch.Ids, this->FetchPoints(scratch.Ids, count, scratch), this->FindCut(type));
    SkipConvexCell(plan, shape, cursor);
  }
  return plan;
}

ConvexCellPlan ConvexCellConversion::PlanPolyhedronCell(
  vtkIdType cell, Scratch& scratch, ConvexCellCursor& cursor) const
{
  ConvexCellPlan plan;
  if (!this->Reader.ReadSurface(cell, this->Canonical, scratch.List, scratch.Surface))
  {
    plan.Fate = ConvexCellPlan::WrongList;
    return plan;
  }
  const std::vector<vtkIdType>& ids = scratch.Surface.GetIds();
  const int count = static_cast<int>(ids.size());
  plan.Fate = FateOfPoints(ids.data(), count);
  return plan.Fate == ConvexCellPlan::Whole
           ? PlanPolyhedron(scratch.Surface, this->FetchPoints(ids.data(), count, scratch),
               this->FindCut(VTK_POLYHEDRON), cursor)
           : plan;
}

void ConvexCellConversion::PlanBlocks(vtkIdType begin, vtkIdType end)
{
  this->Plans.resize(this->NumberOfCells);
  this->BlockStarts.resize(this->GetNumberOfBlocks() + 1);
  this->VisitBlocks(begin, end,
    [this](vtkIdType block, vtkIdType first, vtkIdType last, Scratch& scratch)
    {
      ConvexCellCursor size;
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        this->Plans[cell] = this->PlanCell(cell, scratch, size);
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

void ConvexCellConversion::WriteCell(
  vtkIdType cell, Scratch& scratch, const ConvexCellArrays& arrays, ConvexCellCursor& cursor) const
{
  const ConvexCellPlan& plan = this->Plans[cell];
  const vtkIdType* outputIds = this->OutputIds.empty() ? nullptr : this->OutputIds.data();
  const int type = this->Reader.GetTypes()[cell];
  Shape shape;
  if (plan.Fate > ConvexCellPlan::Tetrahedra)
  {
    return;
  }
  if (ConvexCellReader::ShapeOf(type, shape) &&
      this->Reader.ReadIds(cell, shape, this->Canonical, scratch.List, scratch.Ids))
  {
    WriteConvexCell(plan, shape, scratch.Ids, outputIds, cell, arrays, cursor);
  }
  else if (this->Reader.ReadSurface(cell, this->Canonical, scratch.List, scratch.Surface))
  {
    const std::vector<vtkIdType>& ids = scratch.Surface.GetIds();
    Coordinates* points = this->FetchPoints(ids.data(), static_cast<int>(ids.size()), scratch);
    WritePolyhedron(plan, scratch.Surface, points, outputIds, cell, arrays, cursor);
  }
}

void ConvexCellConversion::WriteBlocks(vtkIdType begin, vtkIdType end)
{
  const ConvexCellArrays arrays = { this->OutputTypes->GetPointer(0), this->Offsets->GetPointer(0),
    this->Ids->GetPointer(0), this->SourceCells->GetPointer(0) };
  this->VisitBlocks(begin, end,
    [&](vtkIdType block, vtkIdType first, vtkIdType last, Scratch& scratch)
    {
      ConvexCellCursor cursor = this->BlockStarts[block];
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        this->WriteCell(cell, scratch, arrays, cursor);
      }
    });
}

void ConvexCellConversion::FillOutput(vtkUnstructuredGrid* output)
{
  this->FillCells(output);
  this->FillPoints(output);
  this->FillCellData(output);
}

void ConvexCellConversion::FillCells(vtkUnstructuredGrid* output)
{
  if (!this->OutputCells)
  {
    this->OutputCells = ConvexCellGrid::Make(this->OutputTypes, this->Offsets, this->Ids);
  }
  output->CopyStructure(this->OutputCells);
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

bool ConvexCellConversion::SharesPointsOf(vtkUnstructuredGridBase* input) const
{
  return this->OutputIds.empty() && input->GetNumberOfPoints() == this->NumberOfPoints;
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
    data->RemoveArray("Imaginary");
  }
  data->AddArray(this->SourceCells);
}

ConvexCellCounts ConvexCellConversion::Count() const
{
  ConvexCellCounts counts = CountConvexCells(this->Plans, this->Reader.GetTypes());
  counts.MergedPoints = this->NumberOfMergedPoints;
  return counts;
}

void ConvexCellConversion::ReleaseWorkingMemory()
{
  this->Reader.Close();
  std::vector<vtkIdType>().swap(this->Canonical);
  std::vector<ConvexCellCursor>().swap(this->BlockStarts);
}
