// A projected tetrahedron: class, silhouette and thickest point, for every numbering of its corners,
// in parallel projection and perspective, and what the near plane leaves of it.

#include "ProjectedPoints.h"
#include "ProjectedTetrahedron.h"
#include "TestScene.h"
#include "TetrahedronParts.h"
#include "ViewRays.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using Places = std::array<glm::dvec3, 4>;

// The eye is at z = 3 and looks down the z axis.
ViewRays MakeRays(bool isParallel, double nearDepth = 0.5)
{
  ViewRays::Transforms transforms;
  transforms.WorldToView = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -3.0));
  transforms.ViewToClip = isParallel ? glm::ortho(-2.0, 2.0, -2.0, 2.0, nearDepth, 9.0)
                                     : glm::perspective(1.0, 1.0, nearDepth, 9.0);
  transforms.Width = transforms.Height = 100;
  ViewRays rays;
  rays.Build(transforms);
  return rays;
}

ProjectedPoints Project(const Places& places, const ViewRays& rays)
{
  std::vector<float> points;
  for (const glm::dvec3& place : places)
  {
    for (int i = 0; i < 3; ++i)
    {
      points.push_back(static_cast<float>(place[i]));
    }
    points.push_back(0.0f);
  }
  ProjectedPoints projected;
  projected.Build(points, rays);
  return projected;
}

ProjectedTetrahedron MakeCell(const ProjectedPoints& points)
{
  // Values that tell the corners' places.
  ProjectedTetrahedron::Values values;
  for (int i = 0; i < 4; ++i)
  {
    values[i] = glm::vec4(glm::vec3(points[i].Place), 1.0f);
  }
  return ProjectedTetrahedron({ { points[0], points[1], points[2], points[3] } }, values, 0);
}

double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

double TriangleArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  return 0.5 * std::abs(Cross(b - a, c - a));
}

double Volume(const Places& p)
{
  return std::abs(glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0])) / 6.0;
}

// All pixels of the hull of four points lie in some two of their triangles: their faces.
double HullArea(const ProjectedTetrahedron& cell)
{
  double sum = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    sum += TriangleArea(cell.GetCorner((i + 1) % 4).GetScreen(),
      cell.GetCorner((i + 2) % 4).GetScreen(), cell.GetCorner((i + 3) % 4).GetScreen());
  }
  return 0.5 * sum;
}

double FanArea(const ProjectedTetrahedron& cell)
{
  std::array<std::array<int, 2>, 4> edges;
  const int count = cell.GetSilhouette(edges);
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
  {
    sum += TriangleArea(cell.GetThickScreen(), cell.GetCorner(edges[i][0]).GetScreen(),
      cell.GetCorner(edges[i][1]).GetScreen());
  }
  return sum;
}

// The ray enters and leaves where the ends say: their values are their places.
void CheckEnds(TestChecks& checks, const ProjectedTetrahedron& cell, const ViewRays& rays)
{
  const std::array<ProjectedTetrahedron::End, 2> ends = cell.GetThickEnds();
  CHECK(ends[0].Depth <= ends[1].Depth);
  for (const ProjectedTetrahedron::End& end : ends)
  {
    CHECK_NEAR(end.Value.a, 1.0, 1e-6);
    const glm::dvec4 view = rays.MeshToView * glm::dvec4(glm::dvec3(end.Value), 1.0);
    CHECK_NEAR(-view.z - rays.Reference, end.Depth, 1e-6);
    const glm::dvec4 clip = glm::dmat4(rays.MeshToClip) * glm::dvec4(glm::dvec3(end.Value), 1.0);
    CHECK_AT_MOST(glm::length(glm::dvec2(clip) / clip.w - cell.GetThickScreen()), 1e-6);
  }
}

void CheckCell(TestChecks& checks, const Places& places, bool isParallel, int expected)
{
  constexpr int Triangles[5] = { 0, 3, 4, 2, 1 };
  const ViewRays rays = MakeRays(isParallel);
  std::array<int, 4> numbering{ { 0, 1, 2, 3 } };
  do
  {
    Places numbered;
    for (int i = 0; i < 4; ++i)
    {
      numbered[i] = places[numbering[i]];
    }
    const ProjectedPoints points = Project(numbered, rays);
    const ProjectedTetrahedron cell = MakeCell(points);
    CHECK(cell.GetClass() == expected);
    std::array<std::array<int, 2>, 4> edges;
    CHECK(cell.GetSilhouette(edges) == Triangles[cell.GetClass()]);
    if (cell.GetClass() != 0)
    {
      CHECK_NEAR(FanArea(cell), HullArea(cell), 1e-12);
      CheckEnds(checks, cell, rays);
      // A pyramid on the screen, 4 wide there: its height is the thickness.
      const auto ends = cell.GetThickEnds();
      const double volume = 4.0 * FanArea(cell) * (ends[1].Depth - ends[0].Depth) / 3.0;
      CHECK(!isParallel || std::abs(volume - Volume(numbered)) < 1e-6);
    }
  } while (std::next_permutation(numbering.begin(), numbering.end()));
}

void CheckClasses(TestChecks& checks)
{
  const Places nearCorner{ { { -1, -1, 0 }, { 1, -1, 0.2 }, { 0, 1, -0.3 }, { 0.1, 0, 0.8 } } };
  Places farCorner = nearCorner;
  farCorner[3].z = -0.9;
  const Places quadrilateral{ { { -1, 0, 0 }, { 1, 0.1, 0.3 }, { 0, -1, 0.9 }, { 0.1, 1, 0.7 } } };
  for (const bool isParallel : { true, false })
  {
    CheckCell(checks, nearCorner, isParallel, 1);
    CheckCell(checks, farCorner, isParallel, 1);
    CheckCell(checks, quadrilateral, isParallel, 2);
  }
  // A face, then two, along the rays of either projection.
  CheckCell(
    checks, { { { -1, 0, 0 }, { 1, 0, 0 }, { 0.25, 0, 0.75 }, { 0, 1, 0.5 } } }, true, 3);
  CheckCell(
    checks, { { { -1, 0, 0 }, { 1, 0, 0 }, { 0.25, 0, 0.75 }, { 0, 1, 0.5 } } }, false, 3);
  CheckCell(
    checks, { { { 0.5, 0, 0 }, { 0.5, 0, 0.75 }, { -1, 0.5, 0.25 }, { 0, 1, 0.5 } } }, true, 4);
  CheckCell(checks, { { { 0, 0, 0 }, { 0, 0, 0.75 }, { -1, 0.5, 0.25 }, { 0, 1, 0.5 } } }, false, 4);
  // Seen edge-on as a whole.
  CheckCell(checks, { { { 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 1, 1 } } }, true, 0);
}

// The share of a tetrahedron's volume where a linear function is positive, from its corners'
// values.
double PositiveShare(const std::array<double, 4>& heights)
{
  double share = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    double term = heights[i] > 0.0 ? std::pow(heights[i], 3) : 0.0;
    for (int j = 0; j < 4; ++j)
    {
      term /= j == i ? 1.0 : heights[i] - heights[j];
    }
    share += term;
  }
  return share;
}

bool IsCornerOf(const ProjectedTetrahedron& cell, const glm::dvec3& place)
{
  for (int i = 0; i < 4; ++i)
  {
    if (cell.GetCorner(i).Place == place)
    {
      return true;
    }
  }
  return false;
}

// Whether the eye at z = 3 is on the side of `nearer` of the face that it shares with `farther`.
bool AreInOrder(const ProjectedTetrahedron& farther, const ProjectedTetrahedron& nearer)
{
  std::vector<glm::dvec3> shared;
  glm::dvec3 other(0.0);
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec3& place = nearer.GetCorner(i).Place;
    (IsCornerOf(farther, place) ? shared.emplace_back() : other) = place;
  }
  if (shared.size() != 3)
  {
    return true;
  }
  const glm::dvec3 normal = glm::cross(shared[1] - shared[0], shared[2] - shared[0]);
  return glm::dot(normal, other - shared[0]) *
           glm::dot(normal, glm::dvec3(0.0, 0.0, 3.0) - shared[0]) >=
         0.0;
}

void CheckNearPlane(TestChecks& checks)
{
  const Places places{ { { -0.5, -0.4, -0.3 }, { 0.6, -0.3, 0.1 }, { -0.1, 0.6, -0.2 },
    { 0.05, 0.1, 0.7 } } };
  constexpr size_t Parts[5] = { 0, 1, 3, 3, 1 };
  for (const double nearPlane : { 0.9, 0.3, -0.1, -0.25, -0.9 })
  {
    const ViewRays rays = MakeRays(false, 3.0 - nearPlane);
    const ProjectedPoints points = Project(places, rays);
    const ProjectedTetrahedron::Corners corners{ { points[0], points[1], points[2], points[3] } };
    const std::vector<ProjectedTetrahedron> parts = TetrahedronParts::BeforeNearPlane(
      points, corners, ProjectedTetrahedron::Values{}, 7);
    std::array<double, 4> heights;
    std::transform(places.begin(), places.end(), heights.begin(),
      [&](const glm::dvec3& place) { return nearPlane - place.z; });
    const auto kept = std::count_if(heights.begin(), heights.end(), [](double h) { return h > 0; });
    CHECK(parts.size() == Parts[kept]);
    double volume = 0.0;
    for (const ProjectedTetrahedron& part : parts)
    {
      volume += Volume({ { part.GetCorner(0).Place, part.GetCorner(1).Place,
        part.GetCorner(2).Place, part.GetCorner(3).Place } });
      CHECK((part.GetCell() == 7) == (kept == 4));
      CHECK(std::all_of(parts.data(), &part,
        [&](const ProjectedTetrahedron& farther) { return AreInOrder(farther, part); }));
    }
    CHECK_NEAR(volume, Volume(places) * PositiveShare(heights), 1e-6);
  }
}
}

int TestProjectedTetrahedron(int, char*[])
{
  TestChecks checks;
  CheckClasses(checks);
  CheckNearPlane(checks);
  return checks.Result();
}
