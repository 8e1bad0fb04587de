#include "NearPlaneCut.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace
{
bool IsBefore(const glm::vec4& a, const glm::vec4& b)
{
  return std::lexicographical_compare(
    glm::value_ptr(a), glm::value_ptr(a) + 4, glm::value_ptr(b), glm::value_ptr(b) + 4);
}
}

//------------------------------------------------------------------------------
float NearPlaneCut::HeightOf(const glm::vec4& corner) const
{
  return glm::dot(glm::vec3(this->Plane), glm::vec3(corner)) + this->Plane.w;
}

//------------------------------------------------------------------------------
glm::vec4 NearPlaneCut::Cross(const glm::vec4& a, const glm::vec4& b) const
{
  // From the same end for both triangles of the edge.
  const glm::vec4& first = IsBefore(a, b) ? a : b;
  const glm::vec4& second = IsBefore(a, b) ? b : a;
  const float height = this->HeightOf(first);
  return glm::mix(first, second, height / (height - this->HeightOf(second)));
}

//------------------------------------------------------------------------------
void NearPlaneCut::AddTriangle(const Triangle& triangle)
{
  std::vector<glm::vec4> polygon;
  for (int i = 0; i < 3; ++i)
  {
    const glm::vec4& corner = triangle[i];
    const glm::vec4& next = triangle[(i + 1) % 3];
    const bool isKept = this->HeightOf(corner) > 0.0f;
    if (isKept)
    {
      polygon.push_back(corner);
    }
    if (isKept != this->HeightOf(next) > 0.0f)
    {
      polygon.push_back(this->Cross(corner, next));
      this->Rim.push_back(polygon.back());
    }
  }
  for (size_t i = 2; i < polygon.size(); ++i)
  {
    this->Kept.push_back({ { polygon[0], polygon[i - 1], polygon[i] } });
  }
}

//------------------------------------------------------------------------------
void NearPlaneCut::AddCap()
{
  glm::vec4 center(0.0f);
  for (const glm::vec4& point : this->Rim)
  {
    center += point / static_cast<float>(this->Rim.size());
  }
  // Seen from behind the plane, where the cap's outside is, the angle falls.
  const glm::vec3 normal(this->Plane);
  const glm::vec3 helper =
    std::abs(normal.x) < 0.5f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
  const glm::vec3 right = glm::normalize(glm::cross(helper, normal));
  const glm::vec3 up = glm::cross(normal, right);
  auto angle = [&](const glm::vec4& point)
  {
    const glm::vec3 offset(point - center);
    return std::atan2(glm::dot(up, offset), glm::dot(right, offset));
  };
  std::sort(this->Rim.begin(), this->Rim.end(),
    [&](const glm::vec4& a, const glm::vec4& b) { return angle(a) > angle(b); });
  // From the middle: the rim of a warped cell is not convex everywhere.
  for (size_t i = 0; i < this->Rim.size(); ++i)
  {
    this->Kept.push_back({ { center, this->Rim[i], this->Rim[(i + 1) % this->Rim.size()] } });
  }
}

//------------------------------------------------------------------------------
std::vector<NearPlaneCut::Triangle> NearPlaneCut::Finish()
{
  this->AddCap();
  std::vector<Triangle> triangles;
  triangles.swap(this->Kept);
  this->Rim.clear();
  return triangles;
}
