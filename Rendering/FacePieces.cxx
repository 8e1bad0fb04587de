#include "FacePieces.h"

#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// A quadrilateral within this of a plane is plane: float coordinates are no better.
constexpr double AbsoluteWarp = 3e-7;
constexpr double RelativeWarp = 1e-6;
// Edges go straight on that turn by less, in radians, as vtkConvexCells has it.
constexpr double Straight = 1e-4;
// A triangle of a piece so much thinner than the other one has no share of it.
constexpr double Sliver = 1e-6;

glm::dvec3 PointAt(const std::vector<float>& points, int id)
{
  return glm::dvec3(glm::make_vec3(&points[4 * static_cast<size_t>(id)]));
}

glm::dvec3 UnitVector(const glm::dvec3& vector)
{
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

// Whether its corners lie in a row, as where a node hangs on an edge.
bool IsFlat(const std::vector<float>& points, int a, int b, int c)
{
  const glm::dvec3 first = PointAt(points, a), second = PointAt(points, b);
  const glm::dvec3 u = second - first, v = PointAt(points, c) - second, w = u + v;
  const double uu = glm::dot(u, u), vv = glm::dot(v, v), ww = glm::dot(w, w);
  const glm::dvec3 cross = glm::cross(u, v);
  return glm::dot(cross, cross) * std::max({ uu, vv, ww }) <= Straight * Straight * uu * vv * ww;
}

// A piece of two flat triangles hides those behind it, and is worse than all others together.
int CountFlat(const std::vector<float>& points, const std::vector<int>& loop, int start)
{
  const int size = static_cast<int>(loop.size());
  int flat = 0;
  bool isFirstFlat = false;
  for (int i = 1; i + 1 < size; ++i)
  {
    const bool isFlat =
      IsFlat(points, loop[start], loop[(start + i) % size], loop[(start + i + 1) % size]);
    flat += isFlat ? 1 : 0;
    flat += isFlat && isFirstFlat && i % 2 == 0 ? size : 0;
    isFirstFlat = isFlat;
  }
  return flat;
}

// From the smallest id with the fewest flat triangles.
void StartFan(const std::vector<float>& points, std::vector<int>& loop)
{
  int best = 0, fewest = loop.size() > 3 ? CountFlat(points, loop, 0) : 0;
  const bool isGood = fewest == 0;
  for (int start = 1; !isGood && start < static_cast<int>(loop.size()); ++start)
  {
    const int flat = CountFlat(points, loop, start);
    if (flat < fewest || (flat == fewest && loop[start] < loop[best]))
    {
      best = start;
      fewest = flat;
    }
  }
  std::rotate(loop.begin(), loop.begin() + best, loop.end());
}

// Newell's normal: the mean of the fan's triangles by area.
glm::dvec3 NormalOf(const std::vector<float>& points, const int* loop, int size)
{
  const glm::dvec3 first = PointAt(points, loop[0]);
  glm::dvec3 normal(0.0);
  for (int i = 2; i < size; ++i)
  {
    normal += glm::cross(PointAt(points, loop[i - 1]) - first, PointAt(points, loop[i]) - first);
  }
  return UnitVector(normal);
}

FacePieces::Plane PlaneOf(const std::vector<float>& points, const int* loop, int size)
{
  const glm::dvec3 mean = NormalOf(points, loop, size);
  FacePieces::Plane plane{ { mean, mean }, false, false };
  if (size == 4)
  {
    const glm::dvec3 first = PointAt(points, loop[0]);
    const int others[3] = { loop[0], loop[2], loop[3] };
    const glm::dvec3 last = PointAt(points, loop[3]) - first;
    const glm::dvec3 normal = NormalOf(points, loop, 3);
    const double height = glm::dot(normal, last);
    plane.IsWarped = std::abs(height) > AbsoluteWarp + RelativeWarp * glm::length(last);
    if (plane.IsWarped)
    {
      plane.Normals[0] = normal;
      plane.Normals[1] = NormalOf(points, others, 3);
      plane.IsRaised = height > 0.0;
    }
  }
  return plane;
}

FacePieces::Shape ShapeOf(
  const std::vector<float>& points, const std::array<int, 4>& corners, const glm::dvec3& normal)
{
  const glm::dvec3 first = PointAt(points, corners[0]);
  const glm::dvec3 edge1 = PointAt(points, corners[1]) - first;
  const glm::dvec3 diagonal = PointAt(points, corners[2]) - first;
  const glm::dvec3 edge3 = PointAt(points, corners[3]) - first;
  const glm::dvec3 across = glm::cross(normal, diagonal);
  const double heights[2] = { -glm::dot(across, edge1), glm::dot(across, edge3) };
  const bool isTriangle = corners[2] == corners[3] || heights[1] <= Sliver * heights[0];
  // Of a sliver that its points do not span nothing is seen: any finite value will do.
  const double height = heights[isTriangle ? 0 : 1];
  const double square = glm::dot(diagonal, diagonal);
  const glm::dvec3 gradientW = height > 0.0 ? across / height : glm::dvec3(0.0);
  const glm::dvec3 gradientU = square > 0.0 ? diagonal / square : glm::dvec3(0.0);
  const double w1 = glm::dot(gradientW, edge1);
  return { glm::vec3(gradientU), isTriangle ? 0.0f : static_cast<float>(glm::dot(gradientU, edge3)),
    glm::vec3(gradientW), w1 < -Sliver ? static_cast<float>(w1) : -1.0f, glm::vec3(first),
    static_cast<float>(glm::dot(gradientU, edge1)) };
}
}

//------------------------------------------------------------------------------
void FacePieces::Build(const std::vector<float>& points, const ConvexCellFaces::Rows& loops)
{
  const int faces = loops.GetNumberOfRows();
  this->Offsets.assign(1, 0);
  for (int face = 0; face < faces; ++face)
  {
    this->Offsets.push_back(this->Offsets.back() + (loops.GetSize(face) - 1) / 2);
  }
  this->Corners.resize(static_cast<size_t>(this->Offsets.back()));
  this->Shapes.resize(this->Corners.size());
  this->Planes.resize(static_cast<size_t>(faces));
  vtkSMPTools::For(0, faces,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<int> fan;
      for (auto face = static_cast<int>(begin); face < end; ++face)
      {
        const int size = loops.GetSize(face);
        fan.assign(loops.GetRow(face), loops.GetRow(face) + size);
        StartFan(points, fan);
        const int* loop = fan.data();
        this->Planes[face] = PlaneOf(points, loop, size);
        const glm::dvec3 normal = NormalOf(points, loop, size);
        for (int piece = this->Offsets[face]; piece < this->Offsets[face + 1]; ++piece)
        {
          const int at = 2 * (piece - this->Offsets[face]);
          this->Corners[piece] = { { loop[0], loop[at + 1], loop[at + 2],
            loop[std::min(at + 3, size - 1)] } };
          this->Shapes[piece] = ShapeOf(points, this->Corners[piece], normal);
          this->Shapes[piece].W1 *= piece + 1 < this->Offsets[face + 1] ? -1.0f : 1.0f;
        }
      }
    });
}
