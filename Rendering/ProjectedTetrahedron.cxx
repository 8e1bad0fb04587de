#include "ProjectedTetrahedron.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace
{
// Of a product of three lengths: what a determinant's rounding can be.
constexpr double Rounding = 1e-15;
}

//------------------------------------------------------------------------------
ProjectedTetrahedron::ProjectedTetrahedron(const Corners& corners, const Values& values, int cell)
  : Points(corners)
  , PointValues(values)
  , Cell(cell)
{
  this->Weigh();
  this->Class = this->FindClass();
  if (this->Class != 0)
  {
    this->Nearer = this->GetEnd(1.0).Depth <= this->GetEnd(-1.0).Depth ? 1.0 : -1.0;
  }
}

//------------------------------------------------------------------------------
void ProjectedTetrahedron::Weigh()
{
  const glm::dvec3& a = this->Points[0].Ray;
  const glm::dvec3& b = this->Points[1].Ray;
  const glm::dvec3& c = this->Points[2].Ray;
  const glm::dvec3& d = this->Points[3].Ray;
  const glm::dvec3 ab = glm::cross(a, b);
  const glm::dvec3 cd = glm::cross(c, d);
  this->Weights = { { glm::dot(b, cd), -glm::dot(a, cd), glm::dot(ab, d), -glm::dot(ab, c) } };
  const std::array<double, 4> squares{ { glm::dot(a, a), glm::dot(b, b), glm::dot(c, c),
    glm::dot(d, d) } };
  const double all = squares[0] * squares[1] * squares[2] * squares[3];
  const double bound = Rounding * Rounding * all;
  for (int i = 0; i < 4; ++i)
  {
    if (this->Weights[i] * this->Weights[i] * squares[i] <= bound)
    {
      this->Weights[i] = 0.0;
    }
  }
}

//------------------------------------------------------------------------------
int ProjectedTetrahedron::CountSign(double sign) const
{
  int count = 0;
  for (const double weight : this->Weights)
  {
    count += weight * sign > 0.0 ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
int ProjectedTetrahedron::FindClass() const
{
  const int positive = this->CountSign(1.0);
  const int negative = this->CountSign(-1.0);
  if (positive == 0 || negative == 0)
  {
    return 0;
  }
  const int zeros = 4 - positive - negative;
  return zeros > 0 ? 2 + zeros : positive == 2 ? 2 : 1;
}

//------------------------------------------------------------------------------
int ProjectedTetrahedron::GetInnerCorner() const
{
  const double sign = this->CountSign(1.0) == 1 ? 1.0 : -1.0;
  int corner = 0;
  while (corner < 3 && this->Weights[corner] * sign <= 0.0)
  {
    ++corner;
  }
  return corner;
}

//------------------------------------------------------------------------------
ProjectedTetrahedron::End ProjectedTetrahedron::GetEnd(double sign) const
{
  double sum = 0.0;
  End end{ 0.0, glm::vec4(0.0f) };
  for (int i = 0; i < 4; ++i)
  {
    const double weight = this->Weights[i] * sign;
    if (weight > 0.0)
    {
      sum += weight;
      end.Depth += weight * this->Points[i].Depth;
    }
  }
  for (int i = 0; i < 4; ++i)
  {
    const double weight = this->Weights[i] * sign;
    end.Value += static_cast<float>(weight > 0.0 ? weight / sum : 0.0) * this->PointValues[i];
  }
  end.Depth /= sum;
  return end;
}

//------------------------------------------------------------------------------
std::array<ProjectedTetrahedron::End, 2> ProjectedTetrahedron::GetThickEnds() const
{
  return { { this->GetEnd(this->Nearer), this->GetEnd(-this->Nearer) } };
}

//------------------------------------------------------------------------------
glm::dvec2 ProjectedTetrahedron::GetThickScreen() const
{
  glm::dvec3 ray(0.0);
  for (int i = 0; i < 4; ++i)
  {
    ray += std::max(this->Weights[i], 0.0) * this->Points[i].Ray;
  }
  return glm::dvec2(ray) / ray.z;
}

//------------------------------------------------------------------------------
int ProjectedTetrahedron::GetSilhouette(std::array<std::array<int, 2>, 4>& edges) const
{
  // An edge, and the corners opposite the two faces that meet there.
  constexpr int Edges[6][4] = { { 0, 1, 2, 3 }, { 0, 2, 1, 3 }, { 0, 3, 1, 2 }, { 1, 2, 0, 3 },
    { 1, 3, 0, 2 }, { 2, 3, 0, 1 } };
  int count = 0;
  for (const auto& edge : Edges)
  {
    if (this->Weights[edge[2]] * this->Weights[edge[3]] < 0.0)
    {
      edges[count++] = { { edge[0], edge[1] } };
    }
  }
  return count;
}
