#include "TileMesh.h"

#include "MortonOrder.h"
#include "TileNeighbours.h"
#include "vtkBoundingBox.h"
#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

namespace
{
// Share of the cells below which the drawn ones alone are put in order faster than all of them.
constexpr double SparseShare = 0.5;
}

//------------------------------------------------------------------------------
void TileMesh::Build(
  const std::vector<float>& points, const std::vector<int>& corners, const Progress& report)
{
  this->OrderCells(points, corners);
  report(0.3);
  this->CopyCells(points, corners);
  report(0.5);
  this->FindOrientations();
  report(0.6);
  this->Neighbours = TileNeighbours::Find(this->Corners, this->GetNumberOfPoints());
  this->CellScalars.clear();
  this->FindSteps();
  this->SetDrawn(std::vector<unsigned char>(this->Source.size(), 1));
}

//------------------------------------------------------------------------------
void TileMesh::OrderCells(const std::vector<float>& points, const std::vector<int>& corners)
{
  const std::size_t cells = corners.size() / 4;
  std::vector<double> middles(3 * cells, 0.0);
  vtkBoundingBox box;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    double* middle = &middles[3 * cell];
    for (int i = 0; i < 4; ++i)
    {
      const float* point = &points[4 * static_cast<std::size_t>(corners[4 * cell + i])];
      std::transform(
        point, point + 3, middle, middle, [](float x, double sum) { return sum + 0.25 * x; });
    }
    box.AddPoint(middle);
  }
  this->Source = cells > 0 ? MortonOrder::Find(middles, box) : std::vector<int>();
}

//------------------------------------------------------------------------------
void TileMesh::CopyCells(const std::vector<float>& points, const std::vector<int>& corners)
{
  std::vector<int> renamed(points.size() / 4, -1);
  this->Points.clear();
  this->PointSource.clear();
  this->Corners.resize(4 * this->Source.size());
  for (std::size_t cell = 0; cell < this->Source.size(); ++cell)
  {
    int* own = &this->Corners[4 * cell];
    for (int i = 0; i < 4; ++i)
    {
      const int old = corners[4 * static_cast<std::size_t>(this->Source[cell]) + i];
      if (renamed[old] < 0)
      {
        renamed[old] = static_cast<int>(this->PointSource.size());
        this->PointSource.push_back(old);
        const auto point = points.begin() + 4 * static_cast<std::ptrdiff_t>(old);
        this->Points.insert(this->Points.end(), point, point + 4);
      }
      own[i] = renamed[old];
    }
    std::sort(own, own + 4);
  }
}

//------------------------------------------------------------------------------
void TileMesh::FindOrientations()
{
  this->Orientations.resize(this->Source.size());
  vtkSMPTools::For(0, this->GetNumberOfCells(),
    [this](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        glm::dvec3 p[4];
        for (int i = 0; i < 4; ++i)
        {
          p[i] = glm::dvec3(glm::make_vec3(&this->Points[4 * this->Corners[4 * cell + i]]));
        }
        const double volume = glm::dot(p[3] - p[0], glm::cross(p[1] - p[0], p[2] - p[0]));
        this->Orientations[cell] = static_cast<signed char>((volume > 0.0) - (volume < 0.0));
      }
    });
}

//------------------------------------------------------------------------------
void TileMesh::FindSteps()
{
  this->Steps.assign(this->Source.size(), this->CellScalars.empty() ? 0 : 15);
  for (std::size_t at = 0; at < this->Neighbours.size(); ++at)
  {
    this->Steps[at / 4] |= static_cast<unsigned char>(this->Neighbours[at] < 0 ? 1 << at % 4 : 0);
  }
  vtkSMPTools::For(0, this->GetNumberOfCells(),
    [this](vtkIdType begin, vtkIdType end)
    {
      for (auto cell = static_cast<int>(begin); cell < static_cast<int>(end); ++cell)
      {
        this->Steps[cell] |= this->IsFolded(cell) ? Folded : static_cast<unsigned char>(0);
      }
    });
}

//------------------------------------------------------------------------------
bool TileMesh::IsFolded(int cell) const
{
  auto liesAbove = [this](int which, int face)
  { return (this->Orientations[which] > 0) == IsInward(face); };
  bool isFolded = this->Orientations[cell] == 0;
  for (int f = 0; f < 4; ++f)
  {
    const int other = this->Neighbours[4 * static_cast<std::size_t>(cell) + f];
    if (other < 0)
    {
      continue;
    }
    const int* own = &this->Corners[4 * static_cast<std::size_t>(cell)];
    const int* corners = &this->Corners[4 * static_cast<std::size_t>(other)];
    const auto* apex = std::find_if(
      corners, corners + 4, [own](int corner) { return std::find(own, own + 4, corner) == own + 4; });
    const auto face = static_cast<int>(apex - corners);
    isFolded = isFolded || face == 4 || this->Orientations[other] == 0 ||
      liesAbove(cell, f) == liesAbove(other, face);
  }
  return isFolded;
}

//------------------------------------------------------------------------------
void TileMesh::SetScalars(const std::vector<float>& values, bool onePerCell)
{
  const bool changesKind = onePerCell == this->CellScalars.empty();
  this->CellScalars.resize(onePerCell ? this->Source.size() : 0);
  if (changesKind)
  {
    this->FindSteps();
  }
  if (onePerCell)
  {
    std::transform(this->Source.begin(), this->Source.end(), this->CellScalars.begin(),
      [&](int source) { return values[source]; });
    return;
  }
  for (std::size_t point = 0; point < this->PointSource.size(); ++point)
  {
    this->Points[4 * point + 3] = values[this->PointSource[point]];
  }
}

//------------------------------------------------------------------------------
bool TileMesh::SetDrawn(const std::vector<unsigned char>& drawn)
{
  bool isNew = this->Drawn.size() != this->Source.size();
  this->Drawn.resize(this->Source.size());
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < this->Source.size(); ++cell)
  {
    const unsigned char now =
      drawn[this->Source[cell]] != 0 && this->Orientations[cell] != 0 ? 1 : 0;
    isNew = isNew || this->Drawn[cell] != now;
    this->Drawn[cell] = now;
    count += now;
  }
  this->IsSparse = static_cast<double>(count) < SparseShare * static_cast<double>(drawn.size());
  this->OrdersEmpty = !this->IsSparse && count < drawn.size();
  return isNew;
}

//------------------------------------------------------------------------------
std::size_t TileMesh::GetMemorySize() const
{
  return 4 * (this->Points.size() + this->Corners.size() + this->Neighbours.size() +
               this->Source.size() + this->PointSource.size() + this->CellScalars.size()) +
         this->Orientations.size() + this->Drawn.size() + this->Steps.size();
}
