// The plain algorithms: a polyhedron that has no tetrahedra without a new point, sides of surfaces,
// faces cut alike from either side.

#include "ConvexCellsTesting.h"
#include "FaceTriangulation.h"
#include "TetGenMesher.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace ConvexCellsTesting;

namespace
{
double VolumeOf(const TetGenMesh& mesh)
{
  double volume = 0.0;
  for (const std::array<int, 4>& tetrahedron : mesh.Tetrahedra)
  {
    Point p[4];
    for (int i = 0; i < 12; ++i)
    {
      p[i / 3][i % 3] = mesh.Points[3 * static_cast<size_t>(tetrahedron[i / 3]) + i % 3];
    }
    const double six = Dot(Cross(Minus(p[1], p[0]), Minus(p[2], p[0])), Minus(p[3], p[0]));
    volume += six > 0.0 ? six / 6.0 : std::nan("");
  }
  return volume;
}

// Schoenhardt 1928: a prism whose top is turned, its three sides dented along diagonals.
TetGenSurface Schoenhardt(double turn)
{
  TetGenSurface surface;
  for (int i = 0; i < 6; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * (i % 3) / 3.0 + (i < 3 ? 0.0 : turn);
    surface.Points.insert(
      surface.Points.end(), { std::cos(angle), std::sin(angle), i < 3 ? 0.0 : 1.0 });
  }
  surface.Triangles = { { { 0, 2, 1 } }, { { 3, 4, 5 } } };
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    surface.Triangles.push_back({ { i, next, 3 + next } });
    surface.Triangles.push_back({ { i, 3 + next, 3 + i } });
  }
  return surface;
}

double VolumeInside(const TetGenSurface& surface)
{
  double volume = 0.0;
  for (const std::array<int, 3>& triangle : surface.Triangles)
  {
    Point p[3];
    for (int i = 0; i < 9; ++i)
    {
      p[i / 3][i % 3] = surface.Points[3 * static_cast<size_t>(triangle[i / 3]) + i % 3];
    }
    volume += Dot(p[0], Cross(p[1], p[2])) / 6.0;
  }
  return volume;
}

void TestSchoenhardt()
{
  // Turned so that the diagonals dent inward.
  const TetGenSurface surface = Schoenhardt(0.5);
  const TetGenMesh inside = TetGenMesher::Fill(surface, TetGenSettings());
  CHECK(inside.Failure.empty());
  CHECK(inside.Points.size() > surface.Points.size());
  CHECK(std::equal(surface.Points.begin(), surface.Points.end(), inside.Points.begin()));
  CHECK(Near(VolumeOf(inside), VolumeInside(surface), 1e-10));
  TetGenSettings settings;
  settings.FillsHull = true;
  const TetGenMesh outside = TetGenMesher::Fill(surface, settings);
  // The hull of the six points.
  const TetGenMesh hull = TetGenMesher::Triangulate(surface.Points);
  CHECK(Near(VolumeOf(inside) + VolumeOf(outside), VolumeOf(hull), 1e-10));
  CHECK(VolumeOf(outside) > 0.01);
}

void TestOpen()
{
  TetGenSurface surface = Schoenhardt(0.0);
  surface.Triangles.pop_back();
  const TetGenMesh mesh = TetGenMesher::Fill(surface, TetGenSettings());
  CHECK(!mesh.Failure.empty() && mesh.Tetrahedra.empty());
}

// An arrow head that its corner of smallest id does not see whole, and one that it does.
void TestFaces()
{
  const std::vector<double> arrow = { 0, 0, 0, 2, 1, 0, 0, 2, 0, 1, 1, 0 };
  for (int turn = 0; turn < 4; ++turn)
  {
    std::set<std::set<long long>> first;
    for (const bool reversed : { false, true })
    {
      std::vector<long long> ids;
      std::vector<double> points;
      for (int i = 0; i < 4; ++i)
      {
        const int corner = reversed ? 3 - i : i;
        ids.push_back((corner + turn) % 4);
        points.insert(points.end(), &arrow[3 * corner], &arrow[3 * corner] + 3);
      }
      std::set<std::set<long long>> triangles;
      for (const auto& t : FaceTriangulation::Triangulate(ids, points))
      {
        triangles.insert({ ids[t[0]], ids[t[1]], ids[t[2]] });
        const double* p = points.data();
        const double area = (p[3 * t[1]] - p[3 * t[0]]) * (p[3 * t[2] + 1] - p[3 * t[0] + 1]) -
                            (p[3 * t[1] + 1] - p[3 * t[0] + 1]) * (p[3 * t[2]] - p[3 * t[0]]);
        CHECK(reversed ? area < 0.0 : area > 0.0);
      }
      CHECK_EQUAL(triangles.size(), 2);
      CHECK(!reversed || triangles == first);
      first = triangles;
    }
  }
  // Two edges that cross.
  const std::vector<double> bow = { 0, 0, 0, 2, 2, 0, 2, 0, 0, 0, 1, 0 };
  CHECK(FaceTriangulation::Triangulate({ 0, 1, 2, 3 }, bow).size() < 2);
}
}

int TestTetGenMesher(int, char*[])
{
  TestSchoenhardt();
  TestOpen();
  TestFaces();
  return Result();
}
