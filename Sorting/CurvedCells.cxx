#include "CurvedCells.h"

#include "ConvexCellPoints.h"
#include "ConvexCellReader.h"
#include "FaceTriangles.h"
#include "PolyhedronSurface.h"
#include "StarCells.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{
// However the cell is wound. False where no corner sees all of it, but for what is flat.
bool AddCone(vtkIdType cell, const FaceTriangles& triangles, const vtkIdType* ids,
  const double (*points)[3], double flatness, CurvedRefinement& refinement)
{
  for (const double sign : { 1.0, -1.0 })
  {
    const int apex = triangles.FindApex(sign, flatness);
    if (apex >= 0)
    {
      triangles.VisitCone(apex,
        [&](int a, int b, int c)
        {
          const double volume =
            TetrahedralSplit::SixVolumes(points[apex], points[a], points[b], points[c]);
          if (sign * volume >= 0.0)
          {
            refinement.AddStraight(
              cell, { ids[apex], ids[a], ids[sign < 0.0 ? c : b], ids[sign < 0.0 ? b : c] });
          }
        });
      return true;
    }
  }
  return false;
}

// The faces without those nodes that halve an edge of a curved cell: halving it puts them back.
void TakeCorners(const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
  const CurvedRefinement& refinement, std::vector<int>& offsets, std::vector<int>& vertices)
{
  offsets.assign(1, 0);
  vertices.clear();
  for (int face = 0; face < solid.NumberOfFaces; ++face)
  {
    const int* begin = solid.Begin(face);
    const int count = static_cast<int>(solid.End(face) - begin);
    for (int i = 0; i < count; ++i)
    {
      const vtkIdType before = ids[begin[(i + count - 1) % count]], after = ids[begin[(i + 1) % count]];
      if (refinement.GetMiddle(before, after) != ids[begin[i]])
      {
        vertices.push_back(begin[i]);
      }
    }
    offsets.push_back(static_cast<int>(vertices.size()));
  }
}
}

using TetrahedralSplit::Shape;

CurvedCells::CurvedCells(
  const ConvexCellReader& reader, ConvexCellPoints& points, StarCells& stars)
  : Reader(reader)
  , Points(points)
  , Stars(stars)
  , Taken(reader.GetTypes().size(), 0)
  , Fates(reader.GetTypes().size(), ConvexCellPlan::Whole)
  , Starts(reader.GetTypes().size() + 1, 0)
{
}

CurvedCells::~CurvedCells() = default;

bool CurvedCells::HasAny(const std::vector<unsigned char>& types)
{
  Shape twin;
  return std::any_of(types.begin(), types.end(),
    [&twin](unsigned char type) { return CurvedCell::TwinOf(type, twin); });
}

bool CurvedCells::Refine(const std::vector<vtkDataArray*>& arrays, double tolerance,
  const std::function<bool()>& goOn)
{
  CurvedRefinement refinement(this->Reader.GetGrid(), this->Points, arrays, tolerance);
  this->AddCurved(refinement);
  refinement.HalveAt(this->FindNodes());
  while (refinement.Mark())
  {
    this->AddNeighbours(refinement);
    refinement.Cut();
    if (!goOn())
    {
      return false;
    }
  }
  this->NumberOfCoarseCells = refinement.GetNumberOfCoarseCells();
  this->TakePieces(refinement.TakePieces());
  return true;
}

void CurvedCells::AddCurved(CurvedRefinement& refinement)
{
  CurvedCell evaluator(this->Reader.GetGrid());
  Shape twin;
  for (std::size_t cell = 0; cell < this->Taken.size(); ++cell)
  {
    if (CurvedCell::TwinOf(this->Reader.GetTypes()[cell], twin))
    {
      this->Taken[cell] = 1;
      this->AddCell(static_cast<vtkIdType>(cell), evaluator, refinement);
    }
  }
}

void CurvedCells::AddCell(vtkIdType cell, CurvedCell& evaluator, CurvedRefinement& refinement)
{
  Shape twin;
  const int type = this->Reader.GetTypes()[cell];
  ConvexCellPlan::FateType& fate = this->Fates[cell];
  fate = this->Reader.Refuse(cell);
  if (fate != ConvexCellPlan::Whole)
  {
    return;
  }
  const bool exists =
    this->Reader.ReadAllIds(cell, this->Points.GetCanonical(), this->List, this->Canonical);
  const auto count = static_cast<vtkIdType>(this->Canonical.size());
  if (!exists || !evaluator.HasRightCount(cell, type, count))
  {
    fate = ConvexCellPlan::Invalid;
    return;
  }
  fate = ConvexCellPoints::FateOf(this->Canonical.data(), count);
  if (fate == ConvexCellPlan::Whole && CurvedCell::TwinOf(type, twin))
  {
    refinement.AddCurved(cell, twin, this->Canonical.data());
  }
}

// By input point: whether a polyhedron has it; empty where there is none.
std::vector<char> CurvedCells::FindNodes()
{
  std::vector<char> nodes;
  const std::vector<vtkIdType>& canonical = this->Points.GetCanonical();
  for (vtkIdType cell = 0; cell < static_cast<vtkIdType>(this->Taken.size()); ++cell)
  {
    if (this->Reader.GetTypes()[cell] == VTK_POLYHEDRON &&
        this->Reader.Refuse(cell) == ConvexCellPlan::Whole &&
        this->Reader.ReadAllIds(cell, canonical, this->List, this->Canonical))
    {
      nodes.resize(canonical.size(), 0);
      for (const vtkIdType id : this->Canonical)
      {
        if (id >= 0)
        {
          nodes[id] = 1;
        }
      }
    }
  }
  return nodes;
}

// The straight cells that share an edge that is cut.
void CurvedCells::AddNeighbours(CurvedRefinement& refinement)
{
  const std::vector<vtkIdType>& canonical = this->Points.GetCanonical();
  for (vtkIdType cell = 0; cell < static_cast<vtkIdType>(this->Taken.size()); ++cell)
  {
    if (!this->Taken[cell] && this->Reader.Refuse(cell) == ConvexCellPlan::Whole &&
        this->Reader.ReadAllIds(cell, canonical, this->List, this->Canonical) &&
        this->IsNeighbour(refinement))
    {
      this->Taken[cell] = 1;
      this->Split(cell, refinement);
    }
  }
}

bool CurvedCells::IsNeighbour(const CurvedRefinement& refinement)
{
  std::vector<vtkIdType>& ids = this->Canonical;
  const auto isAway = [&](vtkIdType id) { return id >= 0 && !refinement.GetTouched()[id]; };
  const bool drawable = ConvexCellPoints::FateOf(ids.data(), static_cast<vtkIdType>(ids.size())) ==
                        ConvexCellPlan::Whole;
  ids.erase(std::remove_if(ids.begin(), ids.end(), isAway), ids.end());
  for (std::size_t i = 0; drawable && i < ids.size(); ++i)
  {
    if (std::any_of(ids.begin(), ids.begin() + i,
          [&](vtkIdType other) { return refinement.IsMarked(ids[i], other); }))
    {
      return true;
    }
  }
  return false;
}

void CurvedCells::Split(vtkIdType cell, CurvedRefinement& refinement)
{
  Shape shape;
  vtkIdType ids[TetrahedralSplit::MaximumVertices];
  double points[TetrahedralSplit::MaximumVertices][3];
  const int type = this->Reader.GetTypes()[cell];
  if (type == VTK_POLYHEDRON || type == VTK_CONVEX_POINT_SET)
  {
    this->SplitPolyhedron(cell, refinement);
  }
  else if (ConvexCellReader::ShapeOf(type, shape) &&
           this->Reader.ReadIds(cell, shape, this->Points.GetCanonical(), this->List, ids))
  {
    for (int i = 0; i < TetrahedralSplit::NumberOfVertices(shape); ++i)
    {
      this->Points.Get(ids[i], points[i]);
    }
    const ConvexCellPlan plan = PlanConvexCell(shape, ids, points, ConvexCellCut::All);
    if ((plan.Thin || plan.Uneven) &&
      this->SplitByFaces(cell, TetrahedralSplit::SolidOf(shape), ids, refinement))
    {
      return;
    }
    const TetrahedralSplit::Pieces pieces = TetrahedralSplit::Split(shape, ids, plan.Apex);
    for (int piece = 0; piece < pieces.Count; ++piece)
    {
      const unsigned char* v = pieces.Vertex[piece];
      refinement.AddStraight(cell, { ids[v[0]], ids[v[1]], ids[v[2]], ids[v[3]] });
    }
  }
}

void CurvedCells::SplitPolyhedron(vtkIdType cell, CurvedRefinement& refinement)
{
  PolyhedronSurface surface;
  if (this->Reader.ReadSurface(cell, this->Points, this->List, surface) !=
        ConvexCellPlan::Whole ||
      surface.Orient() != PolyhedronSurface::Defect::None)
  {
    return;
  }
  const vtkIdType* ids = surface.GetIds().data();
  std::vector<int> offsets, vertices;
  TetrahedralSplit::Solid solid = surface.GetSolid();
  TakeCorners(solid, ids, refinement, offsets, vertices);
  solid.FaceOffsets = offsets.data();
  solid.FaceVertices = vertices.data();
  this->SplitByFaces(cell, solid, ids, refinement);
}

// From a corner or from a point within; false where none will do.
bool CurvedCells::SplitByFaces(vtkIdType cell, const TetrahedralSplit::Solid& solid,
  const vtkIdType* ids, CurvedRefinement& refinement)
{
  std::vector<std::array<double, 3>> points(solid.NumberOfVertices);
  for (int i = 0; i < solid.NumberOfVertices; ++i)
  {
    this->Points.Get(ids[i], points[i].data());
  }
  auto scaled = points;
  auto* coordinates = reinterpret_cast<double(*)[3]>(scaled.data());
  TetrahedralSplit::ScaleIfExtreme(coordinates, solid.NumberOfVertices);
  const FaceTriangles triangles(solid, ids, coordinates);
  if (AddCone(cell, triangles, ids, coordinates, 0.0, refinement))
  {
    return true;
  }
  std::vector<Ids> pieces;
  if (!this->Stars.Split(cell, solid, ids, reinterpret_cast<double(*)[3]>(points.data()),
        this->Points, pieces))
  {
    return AddCone(
      cell, triangles, ids, coordinates, TetrahedralSplit::FlatnessTolerance, refinement);
  }
  for (const Ids& piece : pieces)
  {
    refinement.AddStraight(cell, piece);
  }
  return true;
}

void CurvedCells::TakePieces(const std::vector<CurvedRefinement::Tetrahedron>& pieces)
{
  for (const CurvedRefinement::Tetrahedron& piece : pieces)
  {
    ++this->Starts[piece.Cell + 1];
    this->Pieces.push_back(piece.Ids);
  }
  for (std::size_t cell = 1; cell < this->Starts.size(); ++cell)
  {
    this->Starts[cell] += this->Starts[cell - 1];
  }
}
