// Straight polyhedra beside curved cells that are refined: one that only a point within sees all of,
// and some with nodes in the middle of edges, those of the curved cell among them. Volumes stay, and
// every inner face is matched by exactly one other.
#include "CellZoo.h"
#include "ConvexCellsTesting.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <string>

namespace
{
using namespace ConvexCellsTesting;
using Place = std::array<int, 3>; // in eighths
using Loop = std::vector<Place>;

double Square(const Point& x)
{
  return x[0] * x[0] + x[1] * x[1] - x[1] * x[2];
}

/** A row of unit cubes along x; the first is a quadratic hexahedron, the others are polyhedra. */
class Row
{
public:
  /** `hanging`: whether the side across x there has nodes in the middle of its edges; `dented`: by
   *  cube, whether its sides along x are pressed in. */
  Row(const std::vector<bool>& hanging, const std::vector<bool>& dented)
    : Hanging(hanging)
    , Dented(dented)
  {
    this->AddQuadratic();
    for (int cube = 1; cube < static_cast<int>(dented.size()); ++cube)
    {
      this->AddPolyhedron(cube);
    }
  }

  /** With other ids where `seed` is not 0. */
  vtkSmartPointer<vtkUnstructuredGrid> Make(unsigned int seed) const;

private:
  vtkIdType IdOf(const Place& place)
  {
    return this->Ids.emplace(place, static_cast<vtkIdType>(this->Ids.size())).first->second;
  }
  void AddQuadratic();
  void AddPolyhedron(int cube);
  void AddEdge(Loop& loop, const Place& from, const Place& to) const;

  const std::vector<bool> Hanging, Dented;
  std::map<Place, vtkIdType> Ids;
  std::vector<vtkIdType> Quadratic;
  std::vector<Faces> Polyhedra;
};

void Row::AddQuadratic()
{
  const auto cell = CellZoo::Reference(VTK_QUADRATIC_HEXAHEDRON);
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    const Point x = PointOf(cell, i);
    this->Quadratic.push_back(this->IdOf({ int(8.0 * x[0]), int(8.0 * x[1]), int(8.0 * x[2]) }));
  }
}

// Without the end.
void Row::AddEdge(Loop& loop, const Place& from, const Place& to) const
{
  loop.push_back(from);
  if (from[0] == to[0] && this->Hanging[from[0] / 8])
  {
    loop.push_back({ from[0], (from[1] + to[1]) / 2, (from[2] + to[2]) / 2 });
  }
}

void Row::AddPolyhedron(int cube)
{
  constexpr int around[4][2] = { { 0, 0 }, { 8, 0 }, { 8, 8 }, { 0, 8 } };
  const int left = 8 * cube, right = left + 8;
  std::vector<Loop> loops(2);
  for (int i = 0; i < 4; ++i)
  {
    const int* a = around[i];
    const int* b = around[(i + 1) % 4];
    const Place corners[4] = { { left, a[0], a[1] }, { right, a[0], a[1] }, { right, b[0], b[1] },
      { left, b[0], b[1] } };
    this->AddEdge(loops[0], corners[0], corners[3]);
    this->AddEdge(loops[1], corners[1], corners[2]);
    const Place dent = { left + 4, (a[0] + b[0]) / 2 + (a[0] == b[0] ? (a[0] ? -1 : 1) : 0),
      (a[1] + b[1]) / 2 + (a[1] == b[1] ? (a[1] ? -1 : 1) : 0) };
    Loop side;
    for (int edge = 0; edge < 4; ++edge)
    {
      Loop part;
      this->AddEdge(part, corners[edge], corners[(edge + 1) % 4]);
      side.insert(side.end(), part.begin(), part.end());
      part.push_back(corners[(edge + 1) % 4]);
      part.push_back(dent);
      if (this->Dented[cube])
      {
        loops.push_back(part);
      }
    }
    if (!this->Dented[cube])
    {
      loops.push_back(side);
    }
  }
  this->Polyhedra.emplace_back();
  for (const Loop& loop : loops)
  {
    this->Polyhedra.back().emplace_back();
    for (const Place& place : loop)
    {
      this->Polyhedra.back().back().push_back(this->IdOf(place));
    }
  }
}

vtkSmartPointer<vtkUnstructuredGrid> Row::Make(unsigned int seed) const
{
  std::vector<vtkIdType> names(this->Ids.size());
  std::iota(names.begin(), names.end(), vtkIdType{ 0 });
  std::mt19937 random(seed);
  if (seed > 0)
  {
    std::shuffle(names.begin(), names.end(), random);
  }
  const auto rename = [&](std::vector<vtkIdType> ids)
  {
    std::transform(ids.begin(), ids.end(), ids.begin(), [&](vtkIdType id) { return names[id]; });
    return ids;
  };
  std::vector<Point> points(names.size());
  for (const auto& node : this->Ids)
  {
    const Place& at = node.first;
    points[names[node.second]] = { at[0] / 8.0, at[1] / 8.0, at[2] / 8.0 };
  }
  auto grid = MakeGrid(points);
  AddCell(grid, VTK_QUADRATIC_HEXAHEDRON, rename(this->Quadratic));
  for (const Faces& faces : this->Polyhedra)
  {
    Faces renamed(faces.size());
    std::transform(faces.begin(), faces.end(), renamed.begin(), rename);
    ConvexCellsTesting::AddPolyhedron(grid, renamed);
  }
  vtkNew<vtkDoubleArray> scalar;
  for (const Point& x : points)
  {
    scalar->InsertNextValue(Square(x));
  }
  grid->GetPointData()->SetScalars(scalar);
  return grid;
}

// `dents`: how many of its cubes have their sides pressed in, by an eighth.
void Check(const Row& row, int cubes, int dents, const std::string& name)
{
  const double volume = cubes - dents * 4.0 / 24.0;
  const double area =
    2.0 + 4.0 * (cubes - dents) + 16.0 * dents * 0.5 * std::sqrt(0.25 + 1.0 / 64.0);
  for (const unsigned int seed : { 0, 1, 2, 3, 4, 5, 6, 7 })
  {
    for (const double tolerance : { 1.0, 0.02, 0.003 })
    {
      vtkNew<vtkConvexCells> filter;
      filter->SetInputData(row.Make(seed));
      filter->TetrahedraOnlyOn();
      filter->SetTolerance(tolerance);
      filter->Update();
      vtkUnstructuredGrid* output = filter->GetOutput();
      const CellZoo::FaceUses uses = CellZoo::CountFaceUses(output);
      const bool good = CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0) &&
                        CHECK_EQUAL(filter->GetNumberOfFoldedCells(), 0) &&
                        CHECK_EQUAL(uses.More, 0) && CHECK(Near(uses.AreaOfOnce, area, 1e-10)) &&
                        CHECK(Near(TotalVolume(output), volume, 1e-10));
      std::cout << name << ", seed " << seed << ", tolerance " << tolerance << ": "
                << output->GetNumberOfCells() << " cells, area without another off by "
                << uses.AreaOfOnce - area << ", volume by " << TotalVolume(output) - volume
                << (good ? "\n" : ": wrong\n");
    }
  }
}

// The points of each face of a tetrahedron that no other has.
std::vector<std::vector<vtkIdType>> FindLoneFaces(vtkUnstructuredGrid* grid)
{
  std::map<std::vector<vtkIdType>, int> uses;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    for (int face = 0; face < 4; ++face)
    {
      vtkIdList* ids = grid->GetCell(cell)->GetFace(face)->GetPointIds();
      std::vector<vtkIdType> sorted(ids->begin(), ids->end());
      std::sort(sorted.begin(), sorted.end());
      ++uses[sorted];
    }
  }
  std::vector<std::vector<vtkIdType>> lone;
  for (const auto& face : uses)
  {
    if (face.second == 1)
    {
      lone.push_back(face.first);
    }
  }
  return lone;
}

// Edges of the faces without another that do not belong to two of these.
int CountOpenEdges(vtkUnstructuredGrid* grid)
{
  std::map<std::vector<vtkIdType>, int> edges;
  for (const std::vector<vtkIdType>& ids : FindLoneFaces(grid))
  {
    for (std::size_t left = 0; left < 3; ++left)
    {
      ++edges[{ ids[left == 0], ids[left == 2 ? 1 : 2] }];
    }
  }
  return static_cast<int>(std::count_if(
    edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 2; }));
}

// Whether a face lies in a side of two unit cubes along x, or at its bent edge.
bool IsOutside(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& ids)
{
  const auto all = [&](auto&& holds)
  {
    return std::all_of(
      ids.begin(), ids.end(), [&](vtkIdType id) { return holds(PointOf(grid, id)); });
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { 0.0, axis == 0 ? 2.0 : 1.0 })
    {
      if (all([&](const Point& x) { return std::abs(x[axis] - side) < 1e-9; }))
      {
        return true;
      }
    }
  }
  return all([](const Point& x) { return x[2] <= 0.0501; });
}

// Beside a curved edge a polyhedron is cut from none of the nodes that its faces lost: whatever the
// node's number is, here the smallest for some seeds.
void CheckBentEdge()
{
  const Row row({ false, true, false }, { false, false });
  for (unsigned int seed = 0; seed < 40; ++seed)
  {
    auto grid = row.Make(seed);
    double middle[3] = { 1.0, 0.5, 0.0 };
    grid->GetPoints()->SetPoint(grid->FindPoint(middle), 1.1, 0.5, 0.05);
    vtkNew<vtkConvexCells> filter;
    filter->SetInputData(grid);
    filter->TetrahedraOnlyOn();
    filter->SetTolerance(0.005);
    filter->Update();
    vtkUnstructuredGrid* output = filter->GetOutput();
    const auto lone = FindLoneFaces(output);
    const auto open = std::count_if(
      lone.begin(), lone.end(), [&](const auto& ids) { return !IsOutside(output, ids); });
    if (!CHECK_EQUAL(static_cast<int>(open), 0))
    {
      std::cout << "A bent edge, seed " << seed << '\n';
    }
  }
}

// Folded from every corner, and from a point within not, as a hexahedron or a polyhedron; the curved
// cell across its side x has straight edges.
void CheckStar(bool isPolyhedron, const std::vector<vtkIdType>& star)
{
  std::vector<Point> points = { { -.3, .2, .2 }, { .7, 0, .5 }, { .8, 1.4, -.3 }, { .1, .4, -.5 },
    { .3, .4, .6 }, { 1, -.5, .5 }, { 1, 1, 1.3 }, { -.2, 1.3, 1.5 }, { 3, 0, .2 },
    { 3, 1.4, -.2 }, { 3, -.4, .8 }, { 3, 1, 1.2 } };
  std::vector<vtkIdType> curved = { 1, 8, 9, 2, 5, 10, 11, 6 };
  constexpr int ends[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 },
    { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
  for (const auto& end : ends)
  {
    const Point a = points[curved[end[0]]], b = points[curved[end[1]]];
    curved.push_back(static_cast<vtkIdType>(points.size()));
    points.push_back({ 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) });
  }
  auto grid = MakeGrid(points);
  AddCell(grid, VTK_QUADRATIC_HEXAHEDRON, curved);
  isPolyhedron ? AddPolyhedron(grid, BoxFaces(star)) : AddCell(grid, VTK_HEXAHEDRON, star);
  vtkNew<vtkDoubleArray> scalar;
  for (const Point& x : points)
  {
    scalar->InsertNextValue(Square(x));
  }
  grid->GetPointData()->SetScalars(scalar);
  for (const double tolerance : { 0.05, 0.01 })
  {
    vtkNew<vtkConvexCells> filter;
    filter->SetInputData(grid);
    filter->SetTolerance(tolerance);
    filter->Update();
    CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0);
    // The side between them is bent: where it is followed closely, the star is no star.
    CHECK(tolerance < 0.05 || filter->GetNumberOfFoldedCells() == 0);
    CHECK(filter->GetOutput()->GetNumberOfPoints() > grid->GetNumberOfPoints() + 1);
    CHECK_EQUAL(CountOpenEdges(filter->GetOutput()), 0);
    vtkNew<vtkIdList> uses; // no point was added twice
    for (vtkIdType id = grid->GetNumberOfPoints(); id < filter->GetOutput()->GetNumberOfPoints(); ++id)
    {
      filter->GetOutput()->GetPointCells(id, uses);
      CHECK(uses->GetNumberOfIds() > 0);
    }
  }
}
}

int TestConvexCellsNextToCurved(int, char*[])
{
  const bool no = false, yes = true;
  for (const bool isPolyhedron : { no, yes })
  {
    CheckStar(isPolyhedron, { 0, 1, 2, 3, 4, 5, 6, 7 });
    CheckStar(isPolyhedron, { 4, 5, 6, 7, 0, 1, 2, 3 });
  }
  CheckBentEdge();
  Check(Row({ no, no, no, no }, { no, no, no }), 3, 0, "boxes");
  Check(Row({ no, no, yes, no }, { no, no, no }), 3, 0, "nodes away from it");
  Check(Row({ no, no, no, no }, { no, yes, no }), 3, 1, "dented");
  Check(Row({ no, no, yes, no }, { no, yes, no }), 3, 1, "dented, nodes away from it");
  Check(Row({ no, yes, no, no }, { no, no, no }), 3, 0, "its nodes");
  Check(Row({ no, yes, yes, yes }, { no, no, no }), 3, 0, "its nodes, nodes on all");
  Check(Row({ no, yes, yes, no }, { no, yes, yes }), 3, 2, "its nodes, dented, nodes away");
  return Result();
}
