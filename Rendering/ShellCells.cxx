#include "ShellCells.h"

#include "EyeDistance.h"
#include "RasterView.h"
#include "TetrahedraSelection.h"
#include "ViewRays.h"
#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Of a cell that is not seen, of one with a point that is not finite.
constexpr float Outside = std::numeric_limits<float>::max();
constexpr float Lost = std::numeric_limits<float>::infinity();

// Bit i: the point is beyond side i of what is seen, by more than floats are off.
unsigned int SidesOf(const glm::dvec4& clip, const glm::dvec3& viewPoint, const RasterView& view)
{
  const double slack = 1e-4 * std::abs(clip.w);
  unsigned int sides = 0;
  for (int i = 0; i < 3; ++i)
  {
    sides |= clip[i] < -clip.w - slack ? 1u << (2 * i) : 0u;
    sides |= clip[i] > clip.w + slack ? 2u << (2 * i) : 0u;
  }
  unsigned int bit = 64u;
  for (const glm::vec4& plane : *view.ClippingPlanes)
  {
    const double height = glm::dot(glm::dvec3(plane), viewPoint) + plane.w;
    sides |= height < -1e-5 * (glm::length(viewPoint) + std::abs(plane.w)) ? bit : 0u;
    bit *= 2u;
  }
  return sides;
}
}

/// What a point adds to its cells.
struct ShellCells::Place
{
  glm::dvec3 FromEye;
  unsigned int Sides;
};

//------------------------------------------------------------------------------
std::vector<ShellCells::Place> ShellCells::FindPlaces(
  const std::vector<float>& points, const RasterView& view)
{
  const ViewRays& rays = *view.Rays;
  const EyeDistance distance(rays);
  const glm::dmat4 meshToClip(rays.MeshToClip);
  std::vector<Place> places(points.size() / 4);
  vtkSMPTools::For(0, static_cast<vtkIdType>(places.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const glm::dvec3 point(glm::make_vec3(&points[4 * id]));
        const glm::dvec4 homogeneous(point, 1.0);
        places[id].FromEye = distance.To(point);
        places[id].Sides = SidesOf(
          meshToClip * homogeneous, glm::dvec3(rays.MeshToView * homogeneous), view);
      }
    });
  return places;
}

//------------------------------------------------------------------------------
void ShellCells::SetCell(vtkIdType cell, const int* corners, const std::vector<Place>& places,
  const RasterView& view)
{
  glm::dvec3 fromEye[4];
  unsigned int sides = ~0u;
  for (int i = 0; i < 4; ++i)
  {
    fromEye[i] = places[corners[i]].FromEye;
    sides &= places[corners[i]].Sides;
  }
  double range[2];
  EyeDistance(*view.Rays).FindRange(fromEye, range);
  // A range may pass over what is not a number.
  const glm::dvec3 sum = fromEye[0] + fromEye[1] + fromEye[2] + fromEye[3];
  const bool isFinite = std::isfinite(sum.x + sum.y + sum.z);
  // Wider by what rounding to floats takes away.
  this->Nearest[cell] = static_cast<float>(range[0] - 1e-6 * std::abs(range[0]));
  this->Farthest[cell] = static_cast<float>(range[1] + 1e-6 * std::abs(range[1]));
  if (!isFinite || sides != 0u)
  {
    this->Nearest[cell] = isFinite ? Outside : Lost;
    this->Farthest[cell] = -Outside;
  }
}

//------------------------------------------------------------------------------
void ShellCells::Build(const std::vector<float>& points, const std::vector<int>& corners,
  const TetrahedraSelection& selection, const RasterView& view)
{
  const std::vector<Place> places = FindPlaces(points, view);
  const vtkIdType cells = selection.GetNumberOfCells();
  this->Nearest.assign(static_cast<size_t>(cells), Outside);
  this->Farthest.assign(static_cast<size_t>(cells), -Outside);
  vtkSMPTools::For(0, cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        if (selection.IsDrawn(cell))
        {
          this->SetCell(cell, &corners[4 * cell], places, view);
        }
      }
    });
  this->Count(selection);
}

//------------------------------------------------------------------------------
void ShellCells::Count(const TetrahedraSelection& selection)
{
  this->NumberOfSeenCells = this->NumberOfOutsideCells = this->NumberOfLostCells = 0;
  float low = Outside;
  float high = -Outside;
  for (vtkIdType cell = 0; cell < this->GetNumberOfCells(); ++cell)
  {
    const bool isSeen = this->IsSeen(cell);
    const bool isLost = this->Nearest[cell] == Lost;
    this->NumberOfSeenCells += isSeen ? 1 : 0;
    this->NumberOfLostCells += isLost ? 1 : 0;
    this->NumberOfOutsideCells += !isSeen && !isLost && selection.IsDrawn(cell) ? 1 : 0;
    low = isSeen ? std::min(low, this->Nearest[cell]) : low;
    high = isSeen ? std::max(high, this->Farthest[cell]) : high;
  }
  this->Range[0] = low;
  this->Range[1] = high;
}
