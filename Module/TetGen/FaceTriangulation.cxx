#include "FaceTriangulation.h"

#include "ExactOrientation.h"

#include <algorithm>
#include <cmath>

namespace
{
using Triangle = std::array<int, 3>;

class Polygon
{
public:
  Polygon(const std::vector<long long>& ids, const std::vector<double>& points)
  {
    this->SetCorners(ids);
    this->Project(points);
  }

  std::vector<Triangle> Triangulate() const
  {
    std::vector<Triangle> triangles = this->Fan();
    if (triangles.empty())
    {
      triangles = this->ClipEars();
    }
    if (this->IsReversed)
    {
      for (Triangle& triangle : triangles)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
    return triangles;
  }

private:
  // From the smallest id towards the smaller of its neighbours, however the face is wound.
  void SetCorners(const std::vector<long long>& ids)
  {
    const int count = static_cast<int>(ids.size());
    const int start = static_cast<int>(std::min_element(ids.begin(), ids.end()) - ids.begin());
    this->IsReversed = ids[(start + count - 1) % count] < ids[(start + 1) % count];
    for (int i = 0; i < count; ++i)
    {
      this->Corners.push_back((start + (this->IsReversed ? count - i : i)) % count);
    }
  }

  // Drops the axis along which Newell's normal is longest.
  void Project(const std::vector<double>& points)
  {
    double normal[3] = { 0.0, 0.0, 0.0 };
    const auto at = [&](size_t i) { return &points[3 * this->Corners[i % this->Corners.size()]]; };
    for (size_t i = 0; i < this->Corners.size(); ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        normal[axis] +=
          (at(i)[u] - at(i + 1)[u]) * ((at(i)[v] - at(0)[v]) + (at(i + 1)[v] - at(0)[v]));
      }
    }
    const auto shorter = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const int axis = static_cast<int>(std::max_element(normal, normal + 3, shorter) - normal);
    this->Sign = normal[axis] < 0.0 ? -1 : 1;
    this->Flat.resize(points.size() / 3);
    for (size_t i = 0; i < this->Flat.size(); ++i)
    {
      this->Flat[i] = { { points[3 * i + (axis + 1) % 3], points[3 * i + (axis + 2) % 3] } };
    }
  }

  int Turn(int a, int b, int c) const
  {
    return this->Sign *
           ExactOrientation::Turn(this->Flat[a].data(), this->Flat[b].data(), this->Flat[c].data());
  }

  std::vector<Triangle> Fan() const
  {
    std::vector<Triangle> triangles;
    for (size_t i = 1; i + 1 < this->Corners.size(); ++i)
    {
      triangles.push_back({ { this->Corners[0], this->Corners[i], this->Corners[i + 1] } });
      if (this->Turn(triangles.back()[0], triangles.back()[1], triangles.back()[2]) <= 0)
      {
        return {};
      }
    }
    return triangles;
  }

  std::vector<Triangle> ClipEars() const
  {
    std::vector<Triangle> triangles;
    std::vector<int> left = this->Corners;
    for (size_t i = 0, tried = 0; left.size() >= 3 && tried < left.size();)
    {
      const size_t count = left.size();
      const Triangle ear = { { left[(i + count - 1) % count], left[i], left[(i + 1) % count] } };
      if (this->IsEar(ear, left))
      {
        triangles.push_back(ear);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        i = left.empty() ? 0 : i % left.size();
        tried = 0;
      }
      else
      {
        i = (i + 1) % count;
        ++tried;
      }
    }
    return triangles;
  }

  bool IsEar(const Triangle& ear, const std::vector<int>& left) const
  {
    if (this->Turn(ear[0], ear[1], ear[2]) <= 0)
    {
      return false;
    }
    return std::none_of(left.begin(), left.end(),
      [&](int corner)
      {
        return corner != ear[0] && corner != ear[1] && corner != ear[2] &&
               this->Turn(ear[0], ear[1], corner) >= 0 && this->Turn(ear[1], ear[2], corner) >= 0 &&
               this->Turn(ear[2], ear[0], corner) >= 0;
      });
  }

  std::vector<int> Corners;
  std::vector<std::array<double, 2>> Flat; // by corner
  bool IsReversed = false;
  int Sign = 1; // of the area in the plane
};
}

namespace FaceTriangulation
{
//------------------------------------------------------------------------------
std::vector<Triangle> Triangulate(
  const std::vector<long long>& ids, const std::vector<double>& points)
{
  return ids.size() < 3 ? std::vector<Triangle>() : Polygon(ids, points).Triangulate();
}
}
