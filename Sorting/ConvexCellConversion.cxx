#include "ConvexCellConversion.h"

#include "ConePlan.h"
#include "ConvexCellReport.h"
#include "ConvexityTest.h"
#include "CurvedCells.h"
#include "PolyhedronPlan.h"
#include "ReplacedCell.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

namespace
{
using TetrahedralSplit::Shape;

constexpr vtkIdType BlockSize = 4096;
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
  , NumberOfCells(input->GetNumberOfCells())
  , Points(input)
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
  this->IsCurved = CurvedCells::HasAny(this->Reader.GetTypes());
}

void ConvexCellConversion::MergePoints()
{
  this->Points.Merge();
}

bool ConvexCellConversion::HasCurvedCells() const
{
  return this->IsCurved;
}

bool ConvexCellConversion::RefineCurvedCells(const std::vector<vtkDataArray*>& arrays,
  double tolerance, const std::function<bool()>& goOn)
{
  this->Curved = std::make_unique<CurvedCells>(this->Reader, this->Points, this->Stars);
  return this->Curved->Refine(arrays, tolerance, goOn);
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
  auto* points = reinterpret_cast<Coordinates*>(scratch.Points.data());
  this->Points.Get(ids, count, points);
  return points;
}

ConvexCellCut ConvexCellConversion::FindCut(int type, const double (*points)[3]) const
{
  if (this->TetrahedraOnly)
  {
    return ConvexCellCut::All;
  }
  const bool isConvex = type == VTK_TETRA || (type == VTK_VOXEL && ConvexityTest::IsBox(points));
  return isConvex ? ConvexCellCut::None : ConvexCellCut::NonConvex;
}

bool ConvexCellConversion::IsOfFaces(vtkIdType cell) const
{
  const int type = this->Reader.GetTypes()[cell];
  return type == VTK_POLYHEDRON || type == VTK_CONVEX_POINT_SET;
}

// Moves the cursor past what will be written.
ConvexCellPlan ConvexCellConversion::PlanCell(
  vtkIdType cell, Scratch& scratch, ConvexCellCursor& cursor)
{
  ConvexCellPlan plan;
  plan.Fate = this->Curved ? this->Curved->GetFate(cell) : ConvexCellPlan::Whole;
  plan.Fate = plan.Fate == ConvexCellPlan::Whole ? this->Reader.Refuse(cell) : plan.Fate;
  if (plan.Fate != ConvexCellPlan::Whole)
  {
    return plan;
  }
  if (this->Curved && this->Curved->IsReplaced(cell))
  {
    return ReplacedCell::Plan(*this->Curved, this->Points, cell, cursor);
  }
  return this->IsOfFaces(cell) ? this->PlanSurfaceCell(cell, scratch, cursor)
                               : this->PlanLinearCell(cell, scratch, cursor);
}

ConvexCellPlan ConvexCellConversion::PlanLinearCell(
  vtkIdType cell, Scratch& scratch, ConvexCellCursor& cursor)
{
  ConvexCellPlan plan;
  Shape shape;
  const int type = this->Reader.GetTypes()[cell];
  if (!ConvexCellReader::ShapeOf(type, shape))
  {
    plan.Fate = ConvexCellPlan::OtherType;
    return plan;
  }
  if (!this->Reader.ReadIds(cell, shape, this->Points.GetCanonical(), scratch.List, scratch.Ids))
  {
    plan.Fate = ConvexCellPlan::Invalid;
    return plan;
  }
  const int count = TetrahedralSplit::NumberOfVertices(shape);
  plan.Fate = ConvexCellPoints::FateOf(scratch.Ids, count);
  if (plan.Fate != ConvexCellPlan::Whole)
  {
    return plan;
  }
  Coordinates* points = this->FetchPoints(scratch.Ids, count, scratch);
  plan = PlanConvexCell(shape, scratch.Ids, points, this->FindCut(type, points));
  if (plan.Fate == ConvexCellPlan::Tetrahedra && (plan.Thin || plan.Uneven))
  {
    this->PlanByFaces(cell, shape, scratch, plan, cursor);
  }
  if (!plan.Star && !plan.ByFaces)
  {
    SkipConvexCell(plan, shape, cursor);
  }
  return plan;
}

// Looks for a cut that drops nothing and keeps to the triangles of the faces; else `plan` stays, and
// is a folded one where its fans are not these triangles.
void ConvexCellConversion::PlanByFaces(vtkIdType cell, Shape shape, Scratch& scratch,
  ConvexCellPlan& plan, ConvexCellCursor& cursor)
{
  const auto& solid = TetrahedralSplit::SolidOf(shape);
  const vtkIdType* ids = scratch.Ids;
  const double sign = plan.Inverted ? -1.0 : 1.0;
  Coordinates* points = this->FetchPoints(ids, solid.NumberOfVertices, scratch);
  TetrahedralSplit::ScaleIfExtreme(points, solid.NumberOfVertices);
  const FaceTriangles triangles(solid, ids, points);
  if ((plan.Uneven || !triangles.AreFans()) &&
    !ConePlan::Make(triangles, points, sign, plan, cursor))
  {
    this->Stars.Try(cell, solid, ids, this->FetchPoints(ids, solid.NumberOfVertices, scratch), sign,
      this->Points, plan, cursor);
    TetrahedralSplit::ScaleIfExtreme(points, solid.NumberOfVertices);
    if (!plan.Star && !triangles.AreFans())
    {
      plan.Folded = !ConePlan::Make(
        triangles, points, sign, plan, cursor, TetrahedralSplit::FlatnessTolerance);
    }
  }
}

ConvexCellPlan ConvexCellConversion::PlanSurfaceCell(
  vtkIdType cell, Scratch& scratch, ConvexCellCursor& cursor)
{
  ConvexCellPlan plan;
  plan.Fate = this->Reader.ReadSurface(cell, this->Points, scratch.List, scratch.Surface);
  if (plan.Fate != ConvexCellPlan::Whole)
  {
    return plan;
  }
  const std::vector<vtkIdType>& ids = scratch.Surface.GetIds();
  const int count = static_cast<int>(ids.size());
  Coordinates* points = this->FetchPoints(ids.data(), count, scratch);
  plan =
    PlanPolyhedron(scratch.Surface, points, this->FindCut(VTK_POLYHEDRON, points), cursor);
  if (plan.Fate == ConvexCellPlan::Concave)
  {
    this->Stars.Try(cell, scratch.Surface.GetSolid(), ids.data(),
      this->FetchPoints(ids.data(), count, scratch), 1.0, this->Points, plan, cursor);
  }
  if (plan.Fate == ConvexCellPlan::Concave)
  {
    TetrahedralSplit::ScaleIfExtreme(points, count);
    PlanButForFlat(scratch.Surface, points, plan, cursor);
  }
  return plan;
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
  this->Stars.AddPoints(this->Points);
  this->Points.NumberOutput();
  this->BlockStarts.resize(this->GetNumberOfBlocks() + 1);
  for (std::size_t block = 1; block < this->BlockStarts.size(); ++block)
  {
    this->BlockStarts[block].Cell += this->BlockStarts[block - 1].Cell;
    this->BlockStarts[block].Id += this->BlockStarts[block - 1].Id;
  }
  this->Output.Allocate(this->BlockStarts.back());
  this->Fates = ConvexCellFates(this->Plans);
}

void ConvexCellConversion::WriteCell(
  vtkIdType cell, Scratch& scratch, const ConvexCellArrays& arrays, ConvexCellCursor& cursor) const
{
  const ConvexCellPlan& plan = this->Plans[cell];
  if (plan.Fate > ConvexCellPlan::Tetrahedra)
  {
    return;
  }
  if (plan.Replaced)
  {
    ReplacedCell::Write(*this->Curved, this->Points, cell, arrays, cursor);
  }
  else if (this->IsOfFaces(cell))
  {
    this->WriteSurfaceCell(cell, scratch, arrays, cursor);
  }
  else
  {
    this->WriteLinearCell(cell, scratch, arrays, cursor);
  }
}

void ConvexCellConversion::WriteLinearCell(
  vtkIdType cell, Scratch& scratch, const ConvexCellArrays& arrays, ConvexCellCursor& cursor) const
{
  const ConvexCellPlan& plan = this->Plans[cell];
  const vtkIdType* outputIds = this->Points.GetOutputIds();
  const vtkIdType* ids = scratch.Ids;
  Shape shape;
  if (!ConvexCellReader::ShapeOf(this->Reader.GetTypes()[cell], shape) ||
    !this->Reader.ReadIds(cell, shape, this->Points.GetCanonical(), scratch.List, scratch.Ids))
  {
    return;
  }
  if (plan.Star)
  {
    const auto& solid = TetrahedralSplit::SolidOf(shape);
    this->Stars.Write(cell, solid, ids, this->FetchPoints(ids, solid.NumberOfVertices, scratch),
      outputIds, arrays, cursor);
  }
  else if (plan.ByFaces)
  {
    this->WriteByFaces(cell, shape, scratch, arrays, cursor);
  }
  else
  {
    WriteConvexCell(plan, shape, ids, outputIds, cell, arrays, cursor);
  }
}

void ConvexCellConversion::WriteByFaces(vtkIdType cell, Shape shape, Scratch& scratch,
  const ConvexCellArrays& arrays, ConvexCellCursor& cursor) const
{
  const ConvexCellPlan& plan = this->Plans[cell];
  const auto& solid = TetrahedralSplit::SolidOf(shape);
  const vtkIdType* outputIds = this->Points.GetOutputIds();
  Coordinates* points = this->FetchPoints(scratch.Ids, solid.NumberOfVertices, scratch);
  TetrahedralSplit::ScaleIfExtreme(points, solid.NumberOfVertices);
  vtkIdType named[TetrahedralSplit::MaximumVertices];
  std::transform(scratch.Ids, scratch.Ids + solid.NumberOfVertices, named,
    [outputIds](vtkIdType id) { return outputIds ? outputIds[id] : id; });
  ConePlan::Write(plan, FaceTriangles(solid, scratch.Ids, points), points,
    plan.Inverted ? -1.0 : 1.0, named, cell, arrays, cursor);
}

void ConvexCellConversion::WriteSurfaceCell(
  vtkIdType cell, Scratch& scratch, const ConvexCellArrays& arrays, ConvexCellCursor& cursor) const
{
  const ConvexCellPlan& plan = this->Plans[cell];
  const vtkIdType* outputIds = this->Points.GetOutputIds();
  this->Reader.ReadSurface(cell, this->Points, scratch.List, scratch.Surface);
  const std::vector<vtkIdType>& ids = scratch.Surface.GetIds();
  const int count = static_cast<int>(ids.size());
  Coordinates* points = this->FetchPoints(ids.data(), count, scratch);
  if (!plan.Star)
  {
    WritePolyhedron(plan, scratch.Surface, points, outputIds, cell, arrays, cursor);
    return;
  }
  TurnOutward(scratch.Surface, points);
  this->Stars.Write(cell, scratch.Surface.GetSolid(), ids.data(),
    this->FetchPoints(ids.data(), count, scratch), outputIds, arrays, cursor);
}

void ConvexCellConversion::WriteBlocks(vtkIdType begin, vtkIdType end)
{
  const ConvexCellArrays arrays = this->Output.GetArrays();
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
  this->Output.FillCells(output);
  vtkUnstructuredGrid* grid = this->Reader.GetGrid();
  CurvedCell curved(grid ? grid : vtkUnstructuredGrid::SafeDownCast(this->Input));
  this->Points.Fill(this->Input, output,
    [&](const ConvexCellPoints::Origin& origin, vtkIdList* ids, std::vector<double>& weights)
    {
      if (!this->Stars.GetWeights(origin.Cell, ids, weights))
      {
        curved.Take(origin.Cell);
        curved.Locate(origin.Reference);
        ids->DeepCopy(curved.GetIds());
        weights.assign(curved.GetWeights(), curved.GetWeights() + ids->GetNumberOfIds());
      }
    });
  this->Output.FillCellData(this->Input->GetCellData(), this->Fates, output->GetCellData());
}

bool ConvexCellConversion::SharesPointsOf(vtkUnstructuredGridBase* input) const
{
  return !this->Points.GetOutputIds() &&
         input->GetNumberOfPoints() == this->Points.GetNumberOfIds();
}

ConvexCellCounts ConvexCellConversion::Count() const
{
  ConvexCellCounts counts = CountConvexCells(this->Plans, this->Reader.GetTypes());
  counts.MergedPoints = this->Points.GetNumberOfMergedPoints();
  counts.CoarseCells = this->Curved ? this->Curved->GetNumberOfCoarseCells() : 0;
  return counts;
}

void ConvexCellConversion::Report(vtkTable* report) const
{
  ConvexCellReport::Fill(this->Plans, this->Reader.GetTypes(),
    this->Output.CountBySource(this->NumberOfCells), report);
}

void ConvexCellConversion::ReleaseWorkingMemory()
{
  this->Reader.Close();
  this->Points.ReleaseWorkingMemory();
  this->Curved = nullptr;
  std::vector<ConvexCellCursor>().swap(this->BlockStarts);
}
