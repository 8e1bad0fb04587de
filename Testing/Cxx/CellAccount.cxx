#include "CellAccount.h"

#include "CellZoo.h"
#include "ConvexCellCounts.h"
#include "ConvexCellsTesting.h"
#include "SideCut.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace
{
using namespace ConvexCellsTesting;
using Ids = std::vector<vtkIdType>;

// Of a cell of size 1.
constexpr double Tolerance = 1e-10;
// How much of a cell may be dropped where the report says that it is flat.
constexpr double FlatShare = 1e-6;
// Of a thin cell that goes out whole: corners may lie outside the planes of its faces by so much.
constexpr double ThinCell = 1e-6;
constexpr double ToleranceOfPlanes = 1e-9;
// Of a piece that is flat but for its last digits.
constexpr double Rounding = 1e-15;

bool StartsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

Ids IdsOf(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> list;
  grid->GetCells()->GetCellAtId(cell, list);
  return Ids(list->begin(), list->end());
}

// Faces of a polyhedron as they are; of other types by VTK's class.
Faces SidesOf(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  Faces sides;
  vtkNew<vtkIdList> list;
  if (grid->GetCellType(cell) == VTK_POLYHEDRON)
  {
    grid->GetFaceStream(cell, list);
    for (vtkIdType at = 1; at < list->GetNumberOfIds(); at += 1 + list->GetId(at))
    {
      sides.emplace_back(list->begin() + at + 1, list->begin() + at + 1 + list->GetId(at));
    }
    return sides;
  }
  vtkCell* linear = grid->GetCell(cell);
  for (int face = 0; face < linear->GetNumberOfFaces(); ++face)
  {
    vtkIdList* ids = linear->GetFace(face)->GetPointIds();
    sides.emplace_back(ids->begin(), ids->end());
  }
  return sides;
}

// By their names, without points that repeat in a row; sides of fewer than three points are none.
Faces Rename(const Faces& sides, const Ids& names)
{
  Faces renamed;
  for (const Ids& side : sides)
  {
    Ids ids;
    for (const vtkIdType id : side)
    {
      if (ids.empty() || ids.back() != names[id])
      {
        ids.push_back(names[id]);
      }
    }
    while (ids.size() > 1 && ids.front() == ids.back())
    {
      ids.pop_back();
    }
    if (ids.size() > 2)
    {
      renamed.push_back(ids);
    }
  }
  return renamed;
}

// Each edge once in either direction.
bool AreClosed(const Faces& sides)
{
  std::map<std::array<vtkIdType, 2>, int> balance;
  for (const Ids& side : sides)
  {
    for (std::size_t i = 0; i < side.size(); ++i)
    {
      const vtkIdType a = side[i], b = side[(i + 1) % side.size()];
      balance[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : 100;
    }
  }
  return std::all_of(
    balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 101; });
}

// VTK makes a cell of the type to know it.
const std::string& NameOf(int type)
{
  static std::map<int, std::string> names;
  const auto known = names.find(type);
  return known != names.end() ? known->second : names[type] = NameOfCellType(type);
}

double SixVolumes(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return Dot(Cross(Minus(b, a), Minus(c, a)), Minus(d, a));
}
}

//------------------------------------------------------------------------------
CellAccount::CellAccount(vtkUnstructuredGrid* grid, double tolerance)
  : CurveTolerance(tolerance)
  , Grid(grid)
  , Entries(grid->GetNumberOfCells())
{
  std::map<Point, vtkIdType> first;
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    const Point x = PointOf(grid, id);
    const bool isNumber = x[0] == x[0] && x[1] == x[1] && x[2] == x[2];
    this->Canonical.push_back(isNumber ? first.emplace(x, id).first->second : id);
  }
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    this->ReadCell(cell);
  }
}

//------------------------------------------------------------------------------
void CellAccount::ReadCell(vtkIdType cell)
{
  Entry& entry = this->Entries[cell];
  entry.Type = this->Grid->GetCellType(cell);
  const Ids ids = IdsOf(this->Grid, cell);
  entry.Listed = std::all_of(ids.begin(), ids.end(),
    [this](vtkIdType id) { return id >= 0 && id < this->Grid->GetNumberOfPoints(); });
  if (!entry.Listed || ids.empty())
  {
    entry.Finite = true;
    return;
  }
  Point low = PointOf(this->Grid, ids[0]), high = low;
  entry.Finite = true;
  for (const vtkIdType id : ids)
  {
    const Point x = PointOf(this->Grid, id);
    for (int axis = 0; axis < 3; ++axis)
    {
      entry.Finite = entry.Finite && std::isfinite(x[axis]);
      low[axis] = std::min(low[axis], x[axis]);
      high[axis] = std::max(high[axis], x[axis]);
    }
  }
  entry.Size = std::max({ high[0] - low[0], high[1] - low[1], high[2] - low[2] });
  if (entry.Finite && entry.Size > 0.0)
  {
    this->ReadSides(cell);
  }
}

//------------------------------------------------------------------------------
void CellAccount::ReadSides(vtkIdType cell)
{
  Entry& entry = this->Entries[cell];
  const bool isPolyhedron = entry.Type == VTK_POLYHEDRON;
  const std::size_t count = IdsOf(this->Grid, cell).size();
  const bool isLinear = entry.Type <= VTK_HEXAGONAL_PRISM && entry.Type >= VTK_TETRA;
  entry.HasSides = isPolyhedron ||
                   (isLinear && static_cast<vtkIdType>(count) ==
                       CellZoo::Reference(entry.Type)->GetNumberOfPoints());
  if (!entry.HasSides)
  {
    return;
  }
  const Faces sides = Rename(SidesOf(this->Grid, cell), this->Canonical);
  entry.HasSides = AreClosed(sides);
  const Point origin = PointOf(this->Grid, IdsOf(this->Grid, cell)[0]);
  const auto at = [&](vtkIdType id)
  {
    Point x = Minus(PointOf(this->Grid, id), origin);
    std::transform(x.begin(), x.end(), x.begin(), [&](double y) { return y / entry.Size; });
    return x;
  };
  for (Ids side : sides)
  {
    std::rotate(side.begin(), std::min_element(side.begin(), side.end()), side.end());
    const bool turned = side.back() < side[1];
    const auto volumeOf = [&](vtkIdType a, vtkIdType b, vtkIdType c)
    { return SixVolumes(at(sides[0][0]), at(a), at(turned ? c : b), at(turned ? b : c)) / 6.0; };
    if (turned)
    {
      std::reverse(side.begin() + 1, side.end());
    }
    SideCut::VisitFan(side, [&](vtkIdType a, vtkIdType b, vtkIdType c)
      { entry.FanVolume += volumeOf(a, b, c); });
    SideCut::Visit(side, at, [&](vtkIdType a, vtkIdType b, vtkIdType c)
      { entry.Volume += volumeOf(a, b, c); });
    entry.RunsBack = entry.RunsBack || SideCut::RunsBack(side, at);
  }
  // VTK's voxel has some of its faces the other way around.
  entry.HasSides = entry.HasSides && entry.Type != VTK_VOXEL;
}

//------------------------------------------------------------------------------
std::string CellAccount::WeighPieces(
  vtkUnstructuredGrid* output, std::vector<double>& volumes) const
{
  auto* source = vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("SourceCell"));
  volumes.assign(this->Entries.size(), -1.0);
  for (vtkIdType piece = 0; source && piece < output->GetNumberOfCells(); ++piece)
  {
    const vtkIdType cell = source->GetValue(piece);
    vtkCell* convex = output->GetCell(piece);
    Point origin;
    convex->GetPoints()->GetPoint(0, origin.data());
    for (vtkIdType i = 0; i < convex->GetNumberOfPoints(); ++i)
    {
      Point x;
      convex->GetPoints()->GetPoint(i, x.data());
      x = Minus(x, origin);
      std::transform(
        x.begin(), x.end(), x.begin(), [&](double y) { return y / this->Entries[cell].Size; });
      convex->GetPoints()->SetPoint(i, x.data());
    }
    const double volume = VolumeWithin(convex);
    if (!(volume > -Rounding) || !std::isfinite(volume))
    {
      std::ostringstream text;
      text << "piece " << piece << " has the volume " << volume;
      return text.str();
    }
    volumes[cell] = std::max(volumes[cell], 0.0) + std::max(volume, 0.0);
  }
  return source ? "" : "no SourceCell";
}

//------------------------------------------------------------------------------
std::string CellAccount::CheckEntry(
  Entry& entry, const std::string& why, double volume, bool tetrahedraOnly)
{
  std::ostringstream text;
  text.precision(12);
  text << why << ", volume " << volume << " for " << entry.Volume << " of size " << entry.Size;
  const std::string found = text.str();
  const bool isWhole = why.empty() || StartsWith(why, "cut into") ||
                       StartsWith(why, "not convex") || StartsWith(why, "no corner") ||
                       StartsWith(why, "no point sees all:") || StartsWith(why, "repeats");
  if (StartsWith(why, "a point that is not finite") == (entry.Finite || !entry.Listed))
  {
    return StartsWith(why, "wrong list") ? "" : "finite or not: " + found;
  }
  if (isWhole && (volume < 0.0 || !entry.Listed))
  {
    return "nothing of it is there: " + found;
  }
  const double known = std::abs(entry.Volume);
  const double tolerance = StartsWith(why, "no point sees all:") ? Tolerance + FlatShare * known
    : why.empty() && known < ThinCell                            ? ToleranceOfPlanes
                                                                 : Tolerance;
  // Of a face that runs back on itself the fan from the smallest id may be what no other cut replaces.
  const double off = std::abs(volume - std::abs(entry.Volume));
  const double offFan = entry.RunsBack ? std::abs(volume - std::abs(entry.FanVolume)) : off;
  if (isWhole && entry.HasSides && std::min(off, offFan) > tolerance)
  {
    return "another volume: " + found;
  }
  if (why == "zero volume" && entry.HasSides && std::abs(entry.Volume) > Tolerance)
  {
    return "it has a volume: " + found;
  }
  const double least = std::min(std::abs(entry.Volume), std::abs(entry.FanVolume));
  if (StartsWith(why, "folded") && entry.HasSides && volume < least - Tolerance)
  {
    return "too little of it: " + found;
  }
  entry.Made[tetrahedraOnly] = isWhole ? volume : why == "zero volume" ? 0.0 : -1.0;
  const bool differ = !entry.HasSides && entry.Made[0] >= 0.0 && entry.Made[1] >= 0.0 &&
                      std::abs(entry.Made[0] - entry.Made[1]) > tolerance;
  return tetrahedraOnly && differ ? "not what the convex cells had: " + found : "";
}

//------------------------------------------------------------------------------
std::string CellAccount::CheckReport(
  vtkConvexCells* filter, const std::vector<double>& volumes, bool tetrahedraOnly)
{
  vtkTable* report = filter->GetReport();
  vtkIdType in = 0, out = 0;
  for (vtkIdType row = 0; row < report->GetNumberOfRows(); ++row)
  {
    const std::string type = report->GetValueByName(row, "type").ToString();
    in += report->GetValueByName(row, "in").ToLongLong();
    out += report->GetValueByName(row, "out").ToLongLong();
    for (std::size_t cell = 0; cell < this->Entries.size(); ++cell)
    {
      const std::string& name = NameOf(this->Entries[cell].Type);
      const std::string fault = name == type
        ? this->CheckEntry(this->Entries[cell], report->GetValueByName(row, "why").ToString(),
            volumes[cell], tetrahedraOnly)
        : "";
      if (!fault.empty())
      {
        return name + ": " + fault;
      }
    }
  }
  return in == this->Grid->GetNumberOfCells() && out == filter->GetOutput()->GetNumberOfCells()
    ? ""
    : "the report has " + std::to_string(in) + " cells and " + std::to_string(out);
}

//------------------------------------------------------------------------------
std::string CellAccount::FindFault(bool tetrahedraOnly)
{
  vtkNew<vtkConvexCells> filter;
  filter->SetInputData(this->Grid);
  filter->SetTetrahedraOnly(tetrahedraOnly);
  filter->SetTolerance(this->CurveTolerance);
  filter->Update();
  std::vector<double> volumes;
  const std::string fault = this->WeighPieces(filter->GetOutput(), volumes);
  return fault.empty() ? this->CheckReport(filter, volumes, tetrahedraOnly) : fault;
}
