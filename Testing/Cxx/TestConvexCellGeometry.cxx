// The plain arrays behind the mappers of convex cells: shared faces, their pieces, the planes of
// cells, and what the near plane leaves of them.

#include "CellPlanes.h"
#include "ConvexCellFaces.h"
#include "FacePieces.h"
#include "MeshCoordinates.h"
#include "NearPlaneCut.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellType.h"
#include "vtkConvexCells.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace
{
struct Geometry
{
  explicit Geometry(vtkUnstructuredGrid* input)
  {
    vtkNew<vtkConvexCells> convex;
    convex->SetInputData(input);
    convex->Update();
    vtkUnstructuredGrid* grid = convex->GetOutput();
    this->Coordinates.Build(grid);
    this->Cells.Build(grid);
    this->Pieces.Build(this->Coordinates.Points, this->Cells.Loops);
    this->Planes.Build(this->Coordinates.Points, this->Cells, this->Pieces);
  }
  glm::dvec3 PointAt(int id) const
  {
    return glm::dvec3(glm::make_vec3(&this->Coordinates.Points[4 * static_cast<size_t>(id)]));
  }
  MeshCoordinates Coordinates;
  ConvexCellFaces Cells;
  FacePieces Pieces;
  CellPlanes Planes;
};

void CheckFaces(TestChecks& checks)
{
  const Geometry geometry(TestMeshes::Curvilinear(4));
  const ConvexCellFaces& cells = geometry.Cells;
  CHECK(cells.GetNumberOfCells() == 64);
  // 3 directions, 5 layers of 16 faces each; inner ones have two cells.
  CHECK(cells.GetNumberOfFaces() == 240);
  std::vector<int> uses(240, 0);
  for (const int face : cells.Faces.Values)
  {
    ++uses[face];
  }
  CHECK(std::count(uses.begin(), uses.end(), 1) == 96);
  CHECK(std::count(uses.begin(), uses.end(), 2) == 144);
  for (int face = 0; face < 240; ++face)
  {
    const int* loop = cells.Loops.GetRow(face);
    CHECK(cells.Loops.GetSize(face) == 4);
    CHECK(*std::min_element(loop, loop + 4) == loop[0] && loop[1] < loop[3]);
  }
}

// The scalar of a piece by the formula of class FacePieces.
double ScalarAt(const FacePieces::Shape& shape, const double scalars[4], const glm::dvec3& point)
{
  const glm::dvec3 offset = point - glm::dvec3(shape.First);
  const double u = glm::dot(glm::dvec3(shape.GradientU), offset);
  const double w = glm::dot(glm::dvec3(shape.GradientW), offset);
  const double side = w > 0.0 ? w : -w / std::abs(shape.W1);
  const double end = u - (w > 0.0 ? shape.U3 : shape.U1) * side;
  return (1.0 - side - end) * scalars[0] + end * scalars[2] +
         side * (w > 0.0 ? scalars[3] : scalars[1]);
}

void CheckPieces(TestChecks& checks, vtkUnstructuredGrid* grid)
{
  const Geometry geometry(grid);
  const double scalars[4] = { 0.2, 1.0, 0.5, 0.1 };
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double largest = 0.0;
  for (int piece = 0; piece < geometry.Pieces.GetNumberOfPieces(); ++piece)
  {
    const std::array<int, 4>& corners = geometry.Pieces.Corners[piece];
    const int last = corners[2] == corners[3] ? 1 : 2;
    for (int triangle = 1; triangle <= last; ++triangle)
    {
      const double a = share(random), b = (1.0 - a) * share(random), c = 1.0 - a - b;
      const glm::dvec3 point = a * geometry.PointAt(corners[0]) +
                               b * geometry.PointAt(corners[triangle]) +
                               c * geometry.PointAt(corners[triangle + 1]);
      const double expected = a * scalars[0] + b * scalars[triangle] + c * scalars[triangle + 1];
      const double found = ScalarAt(geometry.Pieces.Shapes[piece], scalars, point);
      largest = std::max(largest, std::abs(found - expected));
    }
  }
  CHECK_AT_MOST(largest, 2e-6);
}

void CheckPlanes(TestChecks& checks)
{
  const Geometry geometry(TestMeshes::Curvilinear(4));
  CHECK(geometry.Planes.NumberOfFlatCells == 0);
  std::map<int, std::vector<glm::vec3>> normals;
  for (int cell = 0; cell < 64; ++cell)
  {
    const std::array<int, 4>& header = geometry.Planes.Headers[cell];
    const int planes = header[1] % 65536 + 2 * (header[1] / 65536);
    CHECK(planes >= 6 && planes <= 12);
    for (int i = header[0] + 1; i <= header[0] + planes; ++i)
    {
      // The centre is inside, so offsets are positive.
      CHECK(geometry.Planes.Texels[i].w > 0.0f);
      normals[geometry.Planes.Pieces[i]].emplace_back(geometry.Planes.Texels[i]);
    }
  }
  // Both cells of a face hold the same normals, negated, to the last bit.
  for (const auto& face : normals)
  {
    const auto& list = face.second;
    for (const glm::vec3& normal : list)
    {
      const bool isShared = list.size() == 4 || (list.size() == 2 && list[0] == -list[1]);
      CHECK(!isShared || std::find(list.begin(), list.end(), -normal) != list.end());
    }
  }
}

double VolumeOf(const std::vector<NearPlaneCut::Triangle>& triangles)
{
  double volume = 0.0;
  for (const NearPlaneCut::Triangle& t : triangles)
  {
    const glm::dvec3 a(t[0]), b(t[1]), c(t[2]);
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  return volume;
}

void CheckCut(TestChecks& checks)
{
  const Geometry geometry(TestMeshes::Cube(VTK_HEXAHEDRON));
  NearPlaneCut whole(glm::vec4(0.0f, 0.0f, 1.0f, 9.0f));
  // The cube reaches from -1 to 1 in mesh coordinates; the plane leaves what is above z = 0.5.
  NearPlaneCut straight(glm::vec4(0.0f, 0.0f, 1.0f, -0.5f));
  // Through the centre at any angle: half.
  const glm::vec3 slanted = glm::normalize(glm::vec3(0.3f, -0.5f, 0.7f));
  NearPlaneCut half(glm::vec4(slanted, 0.0f));
  for (int face = 0; face < 6; ++face)
  {
    const std::array<int, 4>& corners = geometry.Pieces.Corners[face];
    for (int second = 1; second < 3; ++second)
    {
      NearPlaneCut::Triangle t;
      const int ids[3] = { corners[0], corners[second], corners[second + 1] };
      for (int i = 0; i < 3; ++i)
      {
        t[i] = glm::vec4(glm::vec3(geometry.PointAt(ids[i])), geometry.PointAt(ids[i]).z);
      }
      const glm::vec3 normal = glm::cross(glm::vec3(t[1] - t[0]), glm::vec3(t[2] - t[0]));
      if (glm::dot(normal, glm::vec3(t[0])) < 0.0f)
      {
        std::swap(t[1], t[2]);
      }
      whole.AddTriangle(t);
      straight.AddTriangle(t);
      half.AddTriangle(t);
    }
  }
  const double size = glm::length(geometry.PointAt(geometry.Pieces.Corners[0][1]) -
                                  geometry.PointAt(geometry.Pieces.Corners[0][0]));
  const double cube = size * size * size;
  const double wholeVolume = VolumeOf(whole.Finish());
  const double halfVolume = VolumeOf(half.Finish());
  CHECK_NEAR(wholeVolume, cube, 1e-6);
  CHECK_NEAR(halfVolume, 0.5 * cube, 1e-6);
  const std::vector<NearPlaneCut::Triangle> top = straight.Finish();
  CHECK_NEAR(VolumeOf(top), size * size * (0.5 * size - 0.5), 1e-6);
  for (const NearPlaneCut::Triangle& t : top)
  {
    for (const glm::vec4& corner : t)
    {
      // The scalar was z: it is carried to the points of the cut.
      CHECK_NEAR(corner.w, corner.z, 1e-6);
      CHECK(corner.z > 0.5f - 1e-6f);
    }
  }
}
}

int TestConvexCellGeometry(int, char*[])
{
  TestChecks checks;
  CheckFaces(checks);
  CheckPieces(checks, TestMeshes::Curvilinear(4));
  CheckPieces(checks, TestMeshes::Cube(VTK_WEDGE));
  CheckPieces(checks, TestMeshes::Cube(VTK_PYRAMID));
  CheckPlanes(checks);
  CheckCut(checks);
  return checks.Result();
}
