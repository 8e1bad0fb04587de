#include "VertexGradients.h"

#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void VertexGradients::SetCells(const std::vector<int>& corners, size_t numberOfPoints)
{
  this->First.assign(numberOfPoints + 1, 0);
  for (const int corner : corners)
  {
    ++this->First[corner + 1];
  }
  for (size_t point = 0; point < numberOfPoints; ++point)
  {
    this->First[point + 1] += this->First[point];
  }
  this->Cells.resize(corners.size());
  std::vector<size_t> next(this->First.begin(), this->First.end() - 1);
  for (size_t i = 0; i < corners.size(); ++i)
  {
    this->Cells[next[corners[i]]++] = static_cast<int>(i / 4);
  }
}

//------------------------------------------------------------------------------
VertexGradients::Share VertexGradients::ShareOf(
  const std::vector<float>& points, const int* corners, const float* scalars)
{
  glm::dvec3 p[4];
  for (int i = 0; i < 4; ++i)
  {
    p[i] = glm::dvec3(glm::make_vec3(&points[4 * static_cast<size_t>(corners[i])]));
  }
  const glm::dvec3 a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const double volume = glm::dot(a, glm::cross(b, c));
  const double base = scalars[corners[0]];
  // Differences, so that equal scalars give zero to the last digit; no division, so that slivers
  // weigh no more than they are.
  const glm::dvec3 gradient = std::copysign(1.0, volume) *
    ((scalars[corners[1]] - base) * glm::cross(b, c) +
      (scalars[corners[2]] - base) * glm::cross(c, a) +
      (scalars[corners[3]] - base) * glm::cross(a, b));
  const bool good = volume != 0.0 && std::isfinite(glm::dot(gradient, gradient));
  return good ? Share{ { gradient.x, gradient.y, gradient.z }, std::abs(volume) }
              : Share{ { 0.0, 0.0, 0.0 }, 0.0 };
}

//------------------------------------------------------------------------------
void VertexGradients::Gather(size_t point, const int* begin, const int* end, const Share* shares)
{
  glm::dvec3 gradient(0.0);
  double volume = 0.0;
  for (const int* cell = begin; cell != end; ++cell)
  {
    gradient += glm::make_vec3(shares[*cell].Gradient);
    volume += shares[*cell].Volume;
  }
  const glm::vec3 mean(volume > 0.0 ? gradient / volume : glm::dvec3(0.0));
  std::copy_n(glm::value_ptr(mean), 3, &this->Values[4 * point]);
}

//------------------------------------------------------------------------------
void VertexGradients::Build(const std::vector<float>& points, const std::vector<int>& corners,
  const std::vector<float>& scalars)
{
  std::vector<Share> shares(corners.size() / 4);
  vtkSMPTools::For(0, static_cast<vtkIdType>(shares.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        shares[cell] = ShareOf(points, &corners[4 * cell], scalars.data());
      }
    });
  this->BuildZero();
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->First.size()) - 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      const int* cells = this->Cells.data();
      for (vtkIdType point = begin; point < end; ++point)
      {
        this->Gather(static_cast<size_t>(point), cells + this->First[point],
          cells + this->First[point + 1], shares.data());
      }
    });
}

//------------------------------------------------------------------------------
void VertexGradients::SetWanted(const std::vector<int>& wanted)
{
  this->WantedPoints = wanted;
  this->WantedCells.clear();
  this->WantedLinks.clear();
  this->WantedFirst.assign(1, 0);
  std::vector<int> numbers(this->Cells.size() / 4, -1);
  for (const int point : wanted)
  {
    for (size_t i = this->First[point]; i < this->First[point + 1]; ++i)
    {
      int& number = numbers[this->Cells[i]];
      if (number < 0)
      {
        number = static_cast<int>(this->WantedCells.size());
        this->WantedCells.push_back(this->Cells[i]);
      }
      this->WantedLinks.push_back(number);
    }
    this->WantedFirst.push_back(this->WantedLinks.size());
  }
  this->WantedShares.resize(this->WantedCells.size());
}

//------------------------------------------------------------------------------
void VertexGradients::BuildAt(const std::vector<float>& points, const std::vector<int>& corners,
  const std::vector<float>& scalars)
{
  this->Values.resize(4 * (this->First.size() - 1));
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->WantedCells.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto cell = static_cast<size_t>(this->WantedCells[i]);
        this->WantedShares[i] = ShareOf(points, &corners[4 * cell], scalars.data());
      }
    });
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->WantedPoints.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      const int* links = this->WantedLinks.data();
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->Gather(static_cast<size_t>(this->WantedPoints[i]), links + this->WantedFirst[i],
          links + this->WantedFirst[i + 1], this->WantedShares.data());
      }
    });
}

//------------------------------------------------------------------------------
void VertexGradients::BuildZero()
{
  this->Values.assign(4 * (this->First.size() - 1), 0.0f);
}
