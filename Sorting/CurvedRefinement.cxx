#include "CurvedRefinement.h"

#include "ConvexCellPoints.h"

#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iterator>

namespace
{
constexpr vtkIdType BlockSize = 1024;

void Append(std::vector<MarkedEdges::Tetrahedron>& to, std::vector<MarkedEdges::Tetrahedron>& from)
{
  to.insert(to.end(), from.begin(), from.end());
  std::vector<MarkedEdges::Tetrahedron>().swap(from);
}
}

CurvedRefinement::CurvedRefinement(vtkUnstructuredGrid* grid, ConvexCellPoints& points,
  const std::vector<vtkDataArray*>& arrays, double tolerance)
  : Grid(grid)
  , Points(points)
  , Tolerance(points, arrays, tolerance)
  , Cell(grid)
  , Roots(grid->GetNumberOfCells(), 0)
  , Touched(points.GetCanonical().size(), 0)
{
}

CurvedRefinement::~CurvedRefinement() = default;

void CurvedRefinement::AddCurved(
  vtkIdType cell, TetrahedralSplit::Shape twin, const vtkIdType* ids)
{
  this->Cell.Take(cell);
  const TetrahedralSplit::Pieces pieces = TetrahedralSplit::Split(twin, ids);
  for (int piece = 0; piece < pieces.Count; ++piece)
  {
    Tetrahedron tetrahedron;
    tetrahedron.Cell = cell;
    tetrahedron.Curved = true;
    for (int corner = 0; corner < 4; ++corner)
    {
      const int vertex = pieces.Vertex[piece][corner];
      tetrahedron.Ids[corner] = ids[vertex];
      tetrahedron.References[corner] = this->Cell.GetCorner(vertex);
    }
    this->Tetrahedra.push_back(tetrahedron);
  }
  this->Roots[cell] = pieces.Count;
}

void CurvedRefinement::AddStraight(vtkIdType cell, const std::array<vtkIdType, 4>& ids)
{
  Tetrahedron tetrahedron;
  tetrahedron.Ids = ids;
  tetrahedron.References = {};
  tetrahedron.Cell = cell;
  this->Tetrahedra.push_back(tetrahedron);
  ++this->Roots[cell];
}

CurvedError& CurvedRefinement::GetError()
{
  std::shared_ptr<CurvedError>& local = this->Errors.Local();
  if (!local)
  {
    local = std::make_shared<CurvedError>(this->Grid, this->Tolerance);
  }
  return *local;
}

std::vector<CurvedRefinement::Place> CurvedRefinement::FindOffEdges()
{
  std::vector<Place> places;
  for (std::size_t i = 0; i < this->Tetrahedra.size(); ++i)
  {
    const Tetrahedron& tetrahedron = this->Tetrahedra[i];
    for (int edge = 0; tetrahedron.Curved && edge < 6; ++edge)
    {
      const vtkIdType a = tetrahedron.Ids[MarkedEdges::Ends[edge][0]];
      const vtkIdType b = tetrahedron.Ids[MarkedEdges::Ends[edge][1]];
      if (a != b && this->Edges.Insert(a, b))
      {
        places.push_back({ i, edge });
      }
    }
  }
  std::vector<char> off(places.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(places.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      CurvedError& error = this->GetError();
      for (vtkIdType i = begin; i < end; ++i)
      {
        off[i] = error.IsCurved(this->Tetrahedra[places[i].Tetrahedron], places[i].Edge, this->Pass < 2);
      }
    });
  const auto isOn = [&](const Place& place) { return !off[&place - places.data()]; };
  std::vector<Place> found;
  std::remove_copy_if(places.begin(), places.end(), std::back_inserter(found), isOn);
  return found;
}

// Of tetrahedra that no edge cuts.
std::vector<CurvedRefinement::Place> CurvedRefinement::FindOffInsides()
{
  std::vector<signed char> edges(this->Tetrahedra.size(), -1);
  const auto isToCut = [this](const Tetrahedron& t)
  {
    return std::any_of(std::begin(MarkedEdges::Ends), std::end(MarkedEdges::Ends),
      [&](const int* ends) { return this->Edges.IsMarked(t.Ids[ends[0]], t.Ids[ends[1]]); });
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(edges.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      CurvedError& error = this->GetError();
      for (vtkIdType i = begin; i < end; ++i)
      {
        Tetrahedron& tetrahedron = this->Tetrahedra[i];
        if (tetrahedron.Curved && !tetrahedron.Settled && !isToCut(tetrahedron))
        {
          edges[i] = static_cast<signed char>(error.FindLongestOfCurved(tetrahedron));
          tetrahedron.Settled = edges[i] < 0;
        }
      }
    });
  std::vector<Place> found;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (edges[i] >= 0)
    {
      found.push_back({ i, edges[i] });
    }
  }
  return found;
}

bool CurvedRefinement::Mark()
{
  this->CountPieces();
  std::size_t halved = this->Pass == 0 && !this->Nodes.empty() ? this->HalveAtNodes() : 0;
  for (const auto find : { &CurvedRefinement::FindOffEdges, &CurvedRefinement::FindOffInsides })
  {
    for (const Place& place : (this->*find)())
    {
      if (this->IsToHalve(place))
      {
        this->Halve(place);
        ++halved;
      }
    }
  }
  ++this->Pass;
  return halved > 0;
}

std::size_t CurvedRefinement::HalveAtNodes()
{
  std::size_t halved = 0;
  for (std::size_t i = 0; i < this->Tetrahedra.size(); ++i)
  {
    const Tetrahedron& tetrahedron = this->Tetrahedra[i];
    this->Cell.Take(tetrahedron.Cell);
    for (int edge = 0; edge < 6; ++edge)
    {
      const Place place{ i, edge };
      const vtkIdType node =
        this->FindNode(tetrahedron, this->Points.Round(this->Cell.Locate(this->MiddleOf(place))));
      if (node >= 0 && this->Nodes[node] && this->IsToHalve(place))
      {
        this->Halve(place);
        ++halved;
      }
    }
  }
  return halved;
}

// One that is not makes its cell a coarse one, and its tetrahedron is let be.
bool CurvedRefinement::IsToHalve(const Place& place)
{
  Tetrahedron& tetrahedron = this->Tetrahedra[place.Tetrahedron];
  const int* ends = MarkedEdges::Ends[place.Edge];
  const double squared = vtkMath::Distance2BetweenPoints(
    tetrahedron.References[ends[0]].data(), tetrahedron.References[ends[1]].data());
  const bool isToHalve = squared > ShortestEdge * ShortestEdge && this->Pass < MaximumPasses &&
                         this->Counts[tetrahedron.Cell] < MaximumPieces;
  if (!isToHalve)
  {
    this->CoarseCells.insert(tetrahedron.Cell);
    tetrahedron.Settled = true;
  }
  return isToHalve;
}

void CurvedRefinement::Halve(const Place& place)
{
  const Tetrahedron& tetrahedron = this->Tetrahedra[place.Tetrahedron];
  const int from = MarkedEdges::Ends[place.Edge][0], to = MarkedEdges::Ends[place.Edge][1];
  const vtkIdType a = tetrahedron.Ids[from], b = tetrahedron.Ids[to];
  if (this->Edges.IsMarked(a, b))
  {
    return; // two insides may ask for it
  }
  CurvedCell::Coordinates x, y;
  this->Points.Get(a, x.data());
  this->Points.Get(b, y.data());
  this->Edges.Mark(a, b, this->FindOrAddPoint(tetrahedron, this->MiddleOf(place)), this->Pass,
    vtkMath::Distance2BetweenPoints(x.data(), y.data()));
  for (const vtkIdType id : { a, b })
  {
    if (id < static_cast<vtkIdType>(this->Touched.size()))
    {
      this->Touched[id] = 1;
    }
  }
}

CurvedCell::Coordinates CurvedRefinement::MiddleOf(const Place& place) const
{
  const auto& references = this->Tetrahedra[place.Tetrahedron].References;
  const int* ends = MarkedEdges::Ends[place.Edge];
  CurvedCell::Coordinates middle;
  for (int axis = 0; axis < 3; ++axis)
  {
    middle[axis] = 0.5 * (references[ends[0]][axis] + references[ends[1]][axis]);
  }
  return middle;
}

// Of the cell at hand. It halves one edge only, and before it ends any: so what halves an edge is
// always newer than its ends, and Cut comes to an end in cells that run into themselves.
vtkIdType CurvedRefinement::FindNode(
  const Tetrahedron& tetrahedron, const CurvedCell::Coordinates& x)
{
  for (vtkIdType i = 0; i < this->Cell.GetIds()->GetNumberOfIds(); ++i)
  {
    CurvedCell::Coordinates node;
    const vtkIdType id = this->Points.GetCanonical()[this->Cell.GetIds()->GetId(i)];
    this->Points.Get(id, node.data());
    const auto& ids = tetrahedron.Ids;
    if (node == x && !this->Touched[id] && std::find(ids.begin(), ids.end(), id) == ids.end())
    {
      return id;
    }
  }
  return -1;
}

// A node of the cell that lies there is taken: a polyhedron next to it may have it, too.
vtkIdType CurvedRefinement::FindOrAddPoint(
  const Tetrahedron& tetrahedron, const CurvedCell::Coordinates& reference)
{
  this->Cell.Take(tetrahedron.Cell);
  const CurvedCell::Coordinates x = this->Points.Round(this->Cell.Locate(reference));
  const vtkIdType node = this->FindNode(tetrahedron, x);
  if (node >= 0)
  {
    this->Touched[node] = 1;
    return node;
  }
  return this->Points.Add(x, { tetrahedron.Cell, reference });
}

void CurvedRefinement::Cut()
{
  const auto count = static_cast<vtkIdType>(this->Tetrahedra.size());
  std::vector<std::vector<Tetrahedron>> blocks((count + BlockSize - 1) / BlockSize);
  vtkSMPTools::For(0, static_cast<vtkIdType>(blocks.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        const auto keep = [&](const Tetrahedron& piece) { blocks[block].push_back(piece); };
        const vtkIdType last = std::min(count, (block + 1) * BlockSize);
        for (vtkIdType i = block * BlockSize; i < last; ++i)
        {
          this->Edges.Cut(this->Tetrahedra[i], keep);
        }
      }
    });
  this->Tetrahedra.clear();
  for (std::vector<Tetrahedron>& block : blocks)
  {
    Append(this->Tetrahedra, block);
  }
}

void CurvedRefinement::CountPieces()
{
  this->Counts.assign(this->Roots.size(), 0);
  for (const Tetrahedron& tetrahedron : this->Tetrahedra)
  {
    ++this->Counts[tetrahedron.Cell];
  }
}

std::vector<CurvedRefinement::Tetrahedron> CurvedRefinement::TakePieces()
{
  this->CountPieces();
  std::vector<Tetrahedron> pieces;
  std::copy_if(this->Tetrahedra.begin(), this->Tetrahedra.end(), std::back_inserter(pieces),
    [&](const Tetrahedron& t) { return this->Counts[t.Cell] > this->Roots[t.Cell]; });
  std::stable_sort(pieces.begin(), pieces.end(),
    [](const Tetrahedron& t, const Tetrahedron& u) { return t.Cell < u.Cell; });
  return pieces;
}
