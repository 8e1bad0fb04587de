// What each approximation makes of one tetrahedron: how many triangles, where, of which colour,
// opacity and thickness.

#include "CellShapes.h"
#include "CentroidApproximation.h"
#include "ExponentialApproximation.h"
#include "ProjectedPoints.h"
#include "ProjectedTetrahedron.h"
#include "ShirleyTuchmanApproximation.h"
#include "TestScene.h"
#include "UniformThicknessApproximation.h"
#include "ViewRays.h"
#include "VoxelApproximation.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace
{
using Places = std::array<glm::dvec3, 4>;

const Places NearCorner{ { { -1, -1, 0 }, { 1, -1, 0.2 }, { 0, 1, -0.3 }, { 0.1, 0, 0.8 } } };
const Places FarCorner{ { { -1, -1, 0 }, { 1, -1, 0.2 }, { 0, 1, -0.3 }, { 0.1, 0, -0.9 } } };
const Places Quadrilateral{ { { -1, 0, 0 }, { 1, 0.1, 0.3 }, { 0, -1, 0.9 }, { 0.1, 1, 0.7 } } };
const Places FaceOnEdge{ { { -1, 0, 0 }, { 1, 0, 0 }, { 0.25, 0, 0.75 }, { 0, 1, 0.5 } } };
const Places TwoOnEdge{ { { 0.5, 0, 0 }, { 0.5, 0, 0.75 }, { -1, 0.5, 0.25 }, { 0, 1, 0.5 } } };

/// A cell in parallel projection, 4 wide on the screen, its values 0.1, 0.2, 0.3 and 0.4.
class OneCell
{
public:
  explicit OneCell(const Places& places)
  {
    ViewRays::Transforms transforms;
    transforms.WorldToView = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -3.0));
    transforms.ViewToClip = glm::ortho(-2.0, 2.0, -2.0, 2.0, 0.5, 9.0);
    transforms.Width = transforms.Height = 100;
    this->Rays.Build(transforms);
    for (const glm::dvec3& place : places)
    {
      for (int i = 0; i < 3; ++i)
      {
        this->Coordinates.push_back(static_cast<float>(place[i]));
      }
      this->Coordinates.push_back(1.0f);
    }
    this->Points.Build(this->Coordinates, this->Rays);
    this->Shapes.Build(this->Coordinates, { 0, 1, 2, 3 }, this->Rays.MeshToWorld);
  }

  ApproximationTriangles Draw(const CellApproximation& approximation) const
  {
    ApproximationTriangles triangles;
    approximation.Append(this->MakeCell(approximation), triangles);
    return triangles;
  }
  ProjectedTetrahedron MakeCell(const CellApproximation& approximation) const
  {
    ProjectedTetrahedron::Values values;
    for (int i = 0; i < 4; ++i)
    {
      values[i] = approximation.Classify(glm::vec4(0.1f * static_cast<float>(i + 1)));
    }
    return ProjectedTetrahedron(
      { { this->Points[0], this->Points[1], this->Points[2], this->Points[3] } }, values, 0);
  }

  ViewRays Rays;
  std::vector<float> Coordinates;
  ProjectedPoints Points;
  CellShapes Shapes;
};

int CountTriangles(const ApproximationTriangles& triangles)
{
  return static_cast<int>(triangles.Indices.size() / 3);
}

const ApproximationTriangles::Vertex& VertexAt(const ApproximationTriangles& triangles, int at)
{
  return triangles.Vertices[triangles.Indices[at]];
}

double Area(const ApproximationTriangles& triangles)
{
  double sum = 0.0;
  for (int i = 0; i < CountTriangles(triangles); ++i)
  {
    const glm::dvec2 a(VertexAt(triangles, 3 * i).Screen);
    const glm::dvec2 b = glm::dvec2(VertexAt(triangles, 3 * i + 1).Screen) - a;
    const glm::dvec2 c = glm::dvec2(VertexAt(triangles, 3 * i + 2).Screen) - a;
    sum += 0.5 * std::abs(b.x * c.y - b.y * c.x);
  }
  return sum;
}

// The triangles' mean thickness times their area.
double Volume(const ApproximationTriangles& triangles)
{
  double sum = 0.0;
  for (int i = 0; i < CountTriangles(triangles); ++i)
  {
    ApproximationTriangles one = triangles;
    one.Indices.assign(triangles.Indices.begin() + 3 * i, triangles.Indices.begin() + 3 * i + 3);
    const double mean = (VertexAt(one, 0).Thickness + VertexAt(one, 1).Thickness +
                          VertexAt(one, 2).Thickness) /
                        3.0;
    sum += 4.0 * Area(one) * mean;
  }
  return sum;
}

double TrueVolume(const Places& p)
{
  return std::abs(glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0])) / 6.0;
}

void CheckThickestPoint(TestChecks& checks)
{
  for (const Places& places : { NearCorner, FarCorner, Quadrilateral, FaceOnEdge, TwoOnEdge })
  {
    const OneCell cell(places);
    const ApproximationTriangles linear = cell.Draw(ShirleyTuchmanApproximation(cell.Points));
    const ApproximationTriangles exponential = cell.Draw(ExponentialApproximation());
    CHECK(linear.Indices == exponential.Indices);
    CHECK_NEAR(Volume(exponential), TrueVolume(places), 1e-6);
    // The middle comes first; extinction there is the mean of both ends, not of the corners.
    const ApproximationTriangles::Vertex& middle = VertexAt(exponential, 0);
    CHECK_NEAR(VertexAt(linear, 0).Value.a,
      1.0 - std::exp(-static_cast<double>(middle.Value.a) * middle.Thickness), 1e-6);
    CHECK(middle.Value.r == middle.Value.a);
    for (const int at : { 1, 2 })
    {
      CHECK(VertexAt(linear, at).Value.a == 0.0f);
      CHECK(VertexAt(exponential, at).Value.a == VertexAt(exponential, at).Value.r);
      CHECK(VertexAt(exponential, at).Thickness == 0.0f);
    }
  }
  // Corners 0 and 1 meet corner 2 a half and an eighth from each: (1 + 2) / 2, mean with 3.
  const OneCell onEdge(FaceOnEdge);
  const float value = VertexAt(onEdge.Draw(ExponentialApproximation()), 0).Value.a;
  CHECK_NEAR(value, 0.5 * (0.375 * 0.1 + 0.625 * 0.2 + 0.3), 1e-6);
}

void CheckSlabs(TestChecks& checks)
{
  const double thickness = 0.5;
  const UniformThicknessApproximation one(thickness, false), two(thickness, true);
  const VoxelApproximation voxel(thickness);
  // Three faces look to the eye, one, two, two, one.
  const Places all[5] = { NearCorner, FarCorner, Quadrilateral, FaceOnEdge, TwoOnEdge };
  for (int i = 0; i < 5; ++i)
  {
    const OneCell cell(all[i]);
    const double area = Area(cell.Draw(ExponentialApproximation()));
    const ApproximationTriangles drawn = cell.Draw(one), other = cell.Draw(two),
                                 flat = cell.Draw(voxel);
    CHECK(drawn.Indices == flat.Indices);
    CHECK_NEAR(Area(drawn), area, 1e-6);
    CHECK_NEAR(Area(other), area, 1e-6);
    CHECK_NEAR(Volume(drawn), 4.0 * area * thickness, 1e-6);
    const bool isCornerNear = i == 0;
    CHECK(CountTriangles(drawn) == (isCornerNear ? 3 : i == 2 || i == 3 ? 2 : 1));
    CHECK(CountTriangles(other) == (isCornerNear ? 1 : CountTriangles(drawn)));
    CHECK(isCornerNear || other.Indices == drawn.Indices);
    double mean = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double opacity = 1.0 - std::exp(-0.1 * (corner + 1) * thickness);
      CHECK_NEAR(drawn.Vertices[corner].Value.a, opacity, 1e-6);
      mean += 0.25 * opacity;
    }
    for (const ApproximationTriangles::Vertex& vertex : flat.Vertices)
    {
      CHECK_NEAR(vertex.Value.a, mean, 1e-6);
      CHECK_NEAR(vertex.Value.r, 0.25, 1e-6);
    }
  }
}

void CheckSpheres(TestChecks& checks)
{
  // As high as the distance of its faces, in a world that stretches it.
  const glm::dmat4 stretch = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 3.0, 0.2));
  const CellShapes::Sphere sphere = CellShapes::InscribedSphere(Quadrilateral, stretch);
  Places world;
  glm::dvec3 center(0.0);
  for (int i = 0; i < 4; ++i)
  {
    world[i] = glm::dvec3(stretch * glm::dvec4(Quadrilateral[i], 1.0));
    center += static_cast<double>(sphere.Weights[i]) * world[i];
  }
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec3& a = world[(i + 1) % 4];
    const glm::dvec3 normal =
      glm::normalize(glm::cross(world[(i + 2) % 4] - a, world[(i + 3) % 4] - a));
    CHECK_NEAR(std::abs(glm::dot(normal, center - a)), sphere.Radius, 1e-6);
  }
  // A regular tetrahedron of edge 2 sqrt 2: r = a / sqrt 24, mean chord 4 / 3 r.
  CellShapes regular;
  regular.Build({ 1, 1, 1, 0, 1, -1, -1, 0, -1, 1, -1, 0, -1, -1, 1, 0 }, { 0, 1, 2, 3 },
    glm::dmat4(1.0));
  CHECK_NEAR(regular.GetSphere(0).Radius, std::sqrt(8.0 / 24.0), 1e-6);
  CHECK_NEAR(regular.GetMeanChord(), 4.0 / 3.0 * std::sqrt(8.0 / 24.0), 1e-6);
}

void CheckCentroid(TestChecks& checks)
{
  const CentroidApproximation::Factors factors{ 2.5, 0.3 };
  const std::vector<glm::vec4> centerValues{ glm::vec4(0.7f) };
  const Places all[5] = { NearCorner, FarCorner, Quadrilateral, FaceOnEdge, TwoOnEdge };
  for (int i = 0; i < 5; ++i)
  {
    const OneCell cell(all[i]);
    const ShirleyTuchmanApproximation shirley(cell.Points);
    const CentroidApproximation centroid(
      { cell.Points, cell.Shapes, centerValues, cell.Rays.MeshToWorld }, factors);
    const ApproximationTriangles drawn = cell.Draw(centroid), thick = cell.Draw(shirley);
    const ApproximationTriangles ends = cell.Draw(ExponentialApproximation());
    const ApproximationTriangles::Vertex& middle = VertexAt(drawn, 0);
    CHECK(drawn.Indices == thick.Indices);
    CHECK_NEAR(Area(drawn), Area(thick), 1e-6);
    if (i == 4)
    {
      CHECK(middle.Value == VertexAt(thick, 0).Value);
      CHECK(VertexAt(drawn, 1).Value.a == 0.0f);
      continue;
    }
    const CellShapes::Sphere& sphere = cell.Shapes.GetSphere(0);
    CHECK_NEAR(middle.Thickness, 2.5 * sphere.Radius, 1e-6);
    // The inner corner's 0.4 and the centre's 0.7; the centre's; both ends'.
    const double value = i < 2 ? 0.55 : i == 2 ? 0.7 : VertexAt(ends, 0).Value.r;
    CHECK_NEAR(middle.Value.r, value, 1e-6);
    CHECK_NEAR(middle.Value.a, 1.0 - std::exp(-value * 2.5 * sphere.Radius), 1e-6);
    CHECK_NEAR(VertexAt(drawn, 1).Value.a, 0.3 * middle.Value.a, 1e-6);
    glm::dvec2 center(0.0);
    for (int corner = 0; corner < 4; ++corner)
    {
      center += static_cast<double>(sphere.Weights[corner]) * cell.Points[corner].GetScreen();
    }
    const glm::dvec2 expected = i == 2 ? center : glm::dvec2(VertexAt(thick, 0).Screen);
    CHECK_AT_MOST(glm::length(glm::dvec2(middle.Screen) - expected), 1e-6);
  }
}
}

int TestApproximationTriangles(int, char*[])
{
  TestChecks checks;
  CheckThickestPoint(checks);
  CheckSlabs(checks);
  CheckSpheres(checks);
  CheckCentroid(checks);
  return checks.Result();
}
