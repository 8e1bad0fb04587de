#include "CollapsedStar.h"

#include "NearestPlace.h"

#include <algorithm>
#include <cmath>

constexpr int CollapsedStar::Places[4][4];

namespace
{
// A place this far outside of a cone, by its size, is outside: more than rounding.
constexpr double Tolerance = 1e-9;

struct Edges
{
  double A[3], B[3], C[3];
  double Rows[3][3]; // B x C, C x A, A x B
  double SixVolumes;

  Edges(const double apex[3], const double a[3], const double b[3], const double c[3])
  {
    for (int i = 0; i < 3; ++i)
    {
      this->A[i] = a[i] - apex[i];
      this->B[i] = b[i] - apex[i];
      this->C[i] = c[i] - apex[i];
    }
    Cross(this->B, this->C, this->Rows[0]);
    this->SixVolumes = Dot(this->A, this->Rows[0]);
  }

  void FillRows()
  {
    Cross(this->C, this->A, this->Rows[1]);
    Cross(this->A, this->B, this->Rows[2]);
  }

  double Quality() const
  {
    const double square =
      std::max({ Dot(this->A, this->A), Dot(this->B, this->B), Dot(this->C, this->C) });
    return this->SixVolumes / (square * std::sqrt(square));
  }

  static void Cross(const double u[3], const double v[3], double w[3])
  {
    w[0] = u[1] * v[2] - u[2] * v[1];
    w[1] = u[2] * v[0] - u[0] * v[2];
    w[2] = u[0] * v[1] - u[1] * v[0];
  }
  static double Dot(const double u[3], const double v[3])
  {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  }
};
}

//------------------------------------------------------------------------------
double CollapsedStar::QualityOf(
  const double apex[3], const double a[3], const double b[3], const double c[3])
{
  return Edges(apex, a, b, c).Quality();
}

//------------------------------------------------------------------------------
bool CollapsedStar::AddCone(const CollapsibleMesh& mesh, int apex, int corner, double leastQuality)
{
  const CollapsibleMesh::Tetrahedron& t = mesh.Get(corner / 4);
  const int* base = CollapsibleMesh::FaceOf[corner % 4];
  Cone cone;
  cone.Corner = corner;
  cone.Points[0] = apex;
  for (int i = 0; i < 3; ++i)
  {
    cone.Points[i + 1] = t[base[i]];
  }
  Edges edges(this->Apex, mesh.GetPoint(cone.Points[1]), mesh.GetPoint(cone.Points[2]),
    mesh.GetPoint(cone.Points[3]));
  if (!(edges.SixVolumes > 0.0 && edges.Quality() > leastQuality))
  {
    return false;
  }
  edges.FillRows();
  for (int i = 0; i < 9; ++i)
  {
    cone.Inverse[i / 3][i % 3] = edges.Rows[i / 3][i % 3] / edges.SixVolumes;
  }
  this->Cones.push_back(cone);
  return true;
}

//------------------------------------------------------------------------------
bool CollapsedStar::Build(
  const CollapsibleMesh& mesh, int to, const std::vector<int>& star, double leastQuality)
{
  this->Cones.clear();
  this->Mesh = &mesh;
  std::copy_n(mesh.GetPoint(to), 3, this->Apex);
  return std::all_of(star.begin(), star.end(),
    [&](int corner)
    { return mesh.Contains(corner / 4, to) || this->AddCone(mesh, to, corner, leastQuality); });
}

//------------------------------------------------------------------------------
int CollapsedStar::FindCone(int tetrahedron, int otherwise) const
{
  const auto found = std::find_if(this->Cones.begin(), this->Cones.end(),
    [tetrahedron](const Cone& cone) { return cone.Corner / 4 == tetrahedron; });
  return found == this->Cones.end() ? otherwise : static_cast<int>(found - this->Cones.begin());
}

//------------------------------------------------------------------------------
void CollapsedStar::Locate(const double x[3], int guess, Location& location) const
{
  const double d[3] = { x[0] - this->Apex[0], x[1] - this->Apex[1], x[2] - this->Apex[2] };
  const int count = this->GetNumberOfCones();
  double best = -1e300;
  double* w = location.Weights;
  for (int i = 0; i < count && best < 0.0; ++i)
  {
    const int cone = guess + i < count ? guess + i : guess + i - count;
    const auto& row = this->Cones[cone].Inverse;
    const double a = Edges::Dot(row[0], d), b = Edges::Dot(row[1], d), c = Edges::Dot(row[2], d);
    const double least = std::min({ a, b, c });
    if (least > best)
    {
      best = least;
      location.Cone = cone;
      w[1] = a;
      w[2] = b;
      w[3] = c;
    }
  }
  w[0] = 1.0 - w[1] - w[2] - w[3];
  location.IsOutside = std::min(best, w[0]) < -Tolerance;
  if (location.IsOutside)
  {
    this->LocateNearest(x, location);
  }
}

//------------------------------------------------------------------------------
void CollapsedStar::LocateNearest(const double x[3], Location& location) const
{
  double least = -1.0;
  for (int cone = 0; cone < this->GetNumberOfCones(); ++cone)
  {
    const double* corners[4];
    std::transform(this->Cones[cone].Points, this->Cones[cone].Points + 4, corners,
      [this](int point) { return this->Mesh->GetPoint(point); });
    double weights[4];
    const double square = NearestPlace::FindOnTetrahedron(x, corners, weights);
    if (least < 0.0 || square < least)
    {
      least = square;
      location.Cone = cone;
      std::copy_n(weights, 4, location.Weights);
    }
  }
}
