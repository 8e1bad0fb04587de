#include "SharedSpheres.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace
{
constexpr double RoundingOfFit = 64.0 * std::numeric_limits<double>::epsilon();
// As many tetrahedra as a hexahedron is cut into, and a few more.
constexpr std::size_t LookBack = 8;
// Of spheres per cell: above it, looking up the cells of each costs more than it saves.
constexpr double LargestShare = 0.75;

// Up to the rounding of a fit to corners of about 1.
bool IsSame(const PowerLift& a, const PowerLift& b)
{
  double difference = std::abs(a.Constant - b.Constant);
  double size = 1.0 + std::abs(a.Constant);
  for (int axis = 0; axis < 3; ++axis)
  {
    difference += std::abs(a.Gradient[axis] - b.Gradient[axis]);
    size += std::abs(a.Gradient[axis]);
  }
  return difference <= RoundingOfFit * size;
}
}

//------------------------------------------------------------------------------
void SharedSpheres::Clear()
{
  this->Lifts.clear();
  this->Cells.clear();
  this->Begins.clear();
}

//------------------------------------------------------------------------------
// Of each cell its sphere; counts them in Lifts.
std::vector<std::uint32_t> SharedSpheres::FindSpheres(std::vector<PowerLift>& lifts)
{
  std::vector<std::uint32_t> spheres(lifts.size());
  for (std::size_t cell = 0; cell < lifts.size(); ++cell)
  {
    std::size_t other = cell;
    const std::size_t first = cell - std::min(cell, LookBack);
    while (other > first && !IsSame(lifts[other - 1], lifts[cell]))
    {
      --other;
    }
    if (other > first)
    {
      spheres[cell] = spheres[other - 1];
      lifts[cell] = lifts[other - 1];
    }
    else
    {
      spheres[cell] = static_cast<std::uint32_t>(this->Lifts.size());
      this->Lifts.push_back(lifts[cell]);
    }
  }
  return spheres;
}

//------------------------------------------------------------------------------
void SharedSpheres::Build(std::vector<PowerLift>& lifts)
{
  this->Clear();
  const std::vector<std::uint32_t> spheres = this->FindSpheres(lifts);
  if (this->Lifts.size() > LargestShare * lifts.size())
  {
    this->Clear();
    return;
  }
  this->Begins.assign(this->Lifts.size() + 1, 0);
  for (const std::uint32_t sphere : spheres)
  {
    ++this->Begins[sphere + 1];
  }
  std::partial_sum(this->Begins.begin(), this->Begins.end(), this->Begins.begin());
  std::vector<std::uint32_t> next(this->Begins);
  this->Cells.resize(lifts.size());
  for (std::size_t cell = 0; cell < lifts.size(); ++cell)
  {
    this->Cells[next[spheres[cell]]++] = static_cast<std::uint32_t>(cell);
  }
}
