#include "TileClusters.h"

#include "ConvexTileMesh.h"
#include "TileLimits.h"
#include "TileMesh.h"
#include "TileView.h"
#include "vtkSMPTools.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Share of a plane's terms by which rounding may move a box.
constexpr double Rounding = 1e-6;
// Pixels that a box may miss the viewport or a tile by: cells of doubt are set up with less.
constexpr double Margin = 1.0;

// What is seen lies on the positive side of all of them; mesh coordinates.
void FindPlanes(const TileView& view, const std::vector<glm::vec4>& clipping,
  std::vector<glm::dvec4>& planes)
{
  const glm::dvec4 x = glm::row(view.MeshToScreen, 0), y = glm::row(view.MeshToScreen, 1);
  const glm::dvec4 u = glm::row(view.MeshToScreen, 2), h = glm::row(view.MeshToScreen, 3);
  planes = { x + Margin * h, (view.Width - 1 + Margin) * h - x,
    y + Margin * h, (view.Height - 1 + Margin) * h - y, view.NearU * h - u, u - view.FarU * h };
  const glm::dmat4 screenToMesh = glm::transpose(view.MeshToScreen);
  for (const glm::vec4& plane : clipping)
  {
    planes.push_back(screenToMesh * (view.ViewPlaneToScreen * glm::dvec4(plane)));
  }
}

// Where each cluster's part of a list begins, if that of a cell begins where `beginOf` says; one more at
// the end.
template <class BeginOf>
std::vector<std::size_t> BeginsOf(int cells, const BeginOf& beginOf)
{
  std::vector<std::size_t> begins;
  for (int cell = 0; cell < cells; cell += TileClusters::Size)
  {
    begins.push_back(beginOf(cell));
  }
  begins.push_back(beginOf(cells));
  return begins;
}

template <class Work>
void ForClusters(int clusters, const Work& work)
{
  vtkSMPTools::For(0, clusters, 256,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cluster = static_cast<int>(begin); cluster < end; ++cluster)
      {
        work(cluster);
      }
    });
}
}

//------------------------------------------------------------------------------
void TileClusters::Build(const TileMesh& mesh)
{
  const int cells = mesh.GetNumberOfCells();
  const auto begins =
    BeginsOf(cells, [](int cell) { return 4 * static_cast<std::size_t>(cell); });
  this->Build(mesh.Points, mesh.Corners, begins, cells);
  this->CountDrawn(mesh);
}

//------------------------------------------------------------------------------
void TileClusters::Build(const ConvexTileMesh& mesh)
{
  auto beginsIn = [&](const ConvexCellFaces::Rows& rows)
  {
    return BeginsOf(mesh.GetNumberOfCells(),
      [&rows](int cell) { return static_cast<std::size_t>(rows.Offsets[cell]); });
  };
  this->Build(
    mesh.Points, mesh.Corners.Values, beginsIn(mesh.Corners), mesh.GetNumberOfCells());
  this->Faces.Build(mesh.Faces.Values, beginsIn(mesh.Faces),
    static_cast<std::size_t>(mesh.GetNumberOfFaces()));
  this->CountDrawn(mesh);
}

//------------------------------------------------------------------------------
void TileClusters::Build(const std::vector<float>& points, const std::vector<int>& corners,
  const std::vector<std::size_t>& begins, int cells)
{
  this->NumberOfCells = cells;
  this->Boxes.resize(begins.size() - 1);
  ForClusters(static_cast<int>(this->Boxes.size()),
    [&](int cluster)
    {
      this->Boxes[cluster] =
        FindBox(points, corners.data() + begins[cluster], corners.data() + begins[cluster + 1]);
    });
  this->Points.Build(corners, begins, points.size() / 4);
  this->Seen.clear();
}

//------------------------------------------------------------------------------
TileClusters::Box TileClusters::FindBox(
  const std::vector<float>& points, const int* begin, const int* end)
{
  Box box;
  std::fill_n(box.Low, 3, std::numeric_limits<float>::max());
  std::fill_n(box.High, 3, std::numeric_limits<float>::lowest());
  for (const int* corner = begin; corner < end; ++corner)
  {
    const float* point = &points[4 * static_cast<std::size_t>(*corner)];
    for (int k = 0; k < 3; ++k)
    {
      box.Low[k] = std::min(box.Low[k], point[k]);
      box.High[k] = std::max(box.High[k], point[k]);
    }
  }
  return box;
}

//------------------------------------------------------------------------------
void TileClusters::CountDrawn(const TileMesh& mesh)
{
  this->CountDrawn(mesh.Drawn, mesh.IsSparse);
}

//------------------------------------------------------------------------------
void TileClusters::CountDrawn(const ConvexTileMesh& mesh)
{
  this->CountDrawn(mesh.Drawn, true);
}

//------------------------------------------------------------------------------
void TileClusters::CountDrawn(const std::vector<unsigned char>& drawn, bool skipsEmpty)
{
  this->NumbersDrawn.assign(this->Boxes.size(), 0);
  this->SkipsEmpty = skipsEmpty;
  for (std::size_t cell = 0; cell < drawn.size(); ++cell)
  {
    this->NumbersDrawn[cell >> Shift] =
      static_cast<unsigned char>(this->NumbersDrawn[cell >> Shift] + drawn[cell]);
  }
}

//------------------------------------------------------------------------------
bool TileClusters::FindSeen(
  const TileView& view, const std::vector<glm::vec4>& planes, const TileLimits* limits)
{
  FindPlanes(view, planes, this->Planes);
  this->SeenBefore.swap(this->Seen);
  this->Seen.resize(this->Boxes.size());
  ForClusters(static_cast<int>(this->Boxes.size()),
    [&](int cluster)
    {
      const Box& box = this->Boxes[cluster];
      const bool isEmpty = this->SkipsEmpty && this->NumbersDrawn[cluster] == 0;
      const bool isSeen = !isEmpty && IsWithin(box, this->Planes) && (!limits || IsBefore(box, view, *limits));
      this->Seen[cluster] = isSeen ? 1 : 0;
    });
  return this->TakeSeen();
}

//------------------------------------------------------------------------------
bool TileClusters::SeeAll()
{
  this->SeenBefore.swap(this->Seen);
  this->Seen.assign(this->Boxes.size(), 1);
  return this->TakeSeen();
}

//------------------------------------------------------------------------------
bool TileClusters::TakeSeen()
{
  const bool isNew = this->Seen != this->SeenBefore;
  if (isNew)
  {
    this->Points.MarkSeen(this->Seen);
    this->Faces.MarkSeen(this->Seen);
  }
  return isNew;
}

//------------------------------------------------------------------------------
bool TileClusters::IsWithin(const Box& box, const std::vector<glm::dvec4>& planes)
{
  return std::all_of(planes.begin(), planes.end(),
    [&box](const glm::dvec4& plane)
    {
      double greatest = plane.w, size = std::abs(plane.w);
      for (int k = 0; k < 3; ++k)
      {
        const double low = plane[k] * box.Low[k], high = plane[k] * box.High[k];
        greatest += std::max(low, high);
        size += std::max(std::abs(low), std::abs(high));
      }
      return greatest >= -Rounding * size;
    });
}

//------------------------------------------------------------------------------
bool TileClusters::IsBefore(const Box& box, const TileView& view, const TileLimits& limits)
{
  double first[2] = { 1e30, 1e30 }, last[2] = { -1e30, -1e30 }, nearest = -1e30;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 point = view.MeshToScreen *
      glm::dvec4((corner & 1) != 0 ? box.High[0] : box.Low[0],
        (corner & 2) != 0 ? box.High[1] : box.Low[1], (corner & 4) != 0 ? box.High[2] : box.Low[2],
        1.0);
    // Behind the eye it has no place on the screen.
    if (point.w <= 0.0)
    {
      return true;
    }
    nearest = std::max(nearest, point.z / point.w);
    for (int k = 0; k < 2; ++k)
    {
      first[k] = std::min(first[k], point[k] / point.w - Margin);
      last[k] = std::max(last[k], point[k] / point.w + Margin);
    }
  }
  const double rounding = Rounding * (std::abs(nearest) + view.WeightOffset);
  return limits.IsBeforeAny(first, last, nearest + rounding);
}

//------------------------------------------------------------------------------
long long TileClusters::CountCellsOutside() const
{
  long long count = 0;
  for (std::size_t cluster = 0; cluster < this->Seen.size(); ++cluster)
  {
    count += this->Seen[cluster] ? 0 : this->NumbersDrawn[cluster];
  }
  return count;
}

//------------------------------------------------------------------------------
long long TileClusters::CountCellsSeen() const
{
  long long count = 0;
  for (std::size_t cluster = 0; cluster < this->Seen.size(); ++cluster)
  {
    const auto first = static_cast<long long>(cluster) << Shift;
    count += this->Seen[cluster] ? std::min<long long>(Size, this->NumberOfCells - first) : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
std::size_t TileClusters::GetMemorySize() const
{
  return sizeof(Box) * this->Boxes.size() + this->Points.GetMemorySize() +
         this->Faces.GetMemorySize() + 3 * this->Seen.size();
}
