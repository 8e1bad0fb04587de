#include "TileClusters.h"

#include "TileCells.h"
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

int NumberOfClusters(const TileMesh& mesh)
{
  return (mesh.GetNumberOfCells() + TileClusters::Size - 1) >> TileClusters::Shift;
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
  const int clusters = NumberOfClusters(mesh);
  this->Boxes.resize(static_cast<std::size_t>(clusters));
  ForClusters(clusters, [&](int cluster) { this->FindBox(mesh, cluster); });
  this->ListPointBlocks(mesh);
  this->SeenPoints.assign((static_cast<std::size_t>(mesh.GetNumberOfPoints()) >> PointShift) + 1, 0);
  this->Seen.clear();
  this->CountDrawn(mesh);
}

//------------------------------------------------------------------------------
void TileClusters::FindBox(const TileMesh& mesh, int cluster)
{
  Box& box = this->Boxes[cluster];
  std::fill_n(box.Low, 3, std::numeric_limits<float>::max());
  std::fill_n(box.High, 3, std::numeric_limits<float>::lowest());
  const std::size_t first = 4 * static_cast<std::size_t>(cluster) << Shift;
  const std::size_t last = std::min(first + 4 * static_cast<std::size_t>(Size), mesh.Corners.size());
  for (std::size_t at = first; at < last; ++at)
  {
    const float* point = &mesh.Points[4 * static_cast<std::size_t>(mesh.Corners[at])];
    for (int k = 0; k < 3; ++k)
    {
      box.Low[k] = std::min(box.Low[k], point[k]);
      box.High[k] = std::max(box.High[k], point[k]);
    }
  }
}

//------------------------------------------------------------------------------
void TileClusters::ListPointBlocks(const TileMesh& mesh)
{
  std::vector<int> lastUse((static_cast<std::size_t>(mesh.GetNumberOfPoints()) >> PointShift) + 1, -1);
  this->Blocks.clear();
  this->BlocksBegin.assign(1, 0);
  for (int cluster = 0; cluster < NumberOfClusters(mesh); ++cluster)
  {
    const std::size_t first = 4 * static_cast<std::size_t>(cluster) << Shift;
    const std::size_t last =
      std::min(first + 4 * static_cast<std::size_t>(Size), mesh.Corners.size());
    for (std::size_t at = first; at < last; ++at)
    {
      const int block = mesh.Corners[at] >> PointShift;
      if (lastUse[block] != cluster)
      {
        lastUse[block] = cluster;
        this->Blocks.push_back(block);
      }
    }
    this->BlocksBegin.push_back(static_cast<int>(this->Blocks.size()));
  }
  this->Blocks.shrink_to_fit();
}

//------------------------------------------------------------------------------
void TileClusters::CountDrawn(const TileMesh& mesh)
{
  this->NumbersDrawn.assign(this->Boxes.size(), 0);
  this->SkipsEmpty = mesh.IsSparse;
  for (std::size_t cell = 0; cell < mesh.Drawn.size(); ++cell)
  {
    this->NumbersDrawn[cell >> Shift] =
      static_cast<unsigned char>(this->NumbersDrawn[cell >> Shift] + mesh.Drawn[cell]);
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
  const bool isNew = this->Seen != this->SeenBefore;
  if (isNew)
  {
    this->MarkPoints();
  }
  return isNew;
}

//------------------------------------------------------------------------------
void TileClusters::MarkPoints()
{
  std::fill(this->SeenPoints.begin(), this->SeenPoints.end(), static_cast<unsigned char>(0));
  for (std::size_t cluster = 0; cluster < this->Seen.size(); ++cluster)
  {
    if (this->Seen[cluster])
    {
      for (int at = this->BlocksBegin[cluster]; at < this->BlocksBegin[cluster + 1]; ++at)
      {
        this->SeenPoints[this->Blocks[at]] = 1;
      }
    }
  }
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
long long TileClusters::CountCellsSeen(const TileMesh& mesh) const
{
  const long long cells = mesh.GetNumberOfCells();
  long long count = 0;
  for (std::size_t cluster = 0; cluster < this->Seen.size(); ++cluster)
  {
    const auto first = static_cast<long long>(cluster) << Shift;
    count += this->Seen[cluster] ? std::min<long long>(Size, cells - first) : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
std::size_t TileClusters::GetMemorySize() const
{
  return sizeof(Box) * this->Boxes.size() + 4 * (this->BlocksBegin.size() + this->Blocks.size()) +
         3 * this->Seen.size() + this->SeenPoints.size();
}
