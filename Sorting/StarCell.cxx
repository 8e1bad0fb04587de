#include "StarCell.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkMeanValueCoordinatesInterpolator.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cmath>

namespace
{
using StarCell::Point;
using StarCell::Triangles;

struct Plane
{
  double Normal[3]; // outward, of length 1
  double Offset;
};

// Twice the area times the normal, outward.
void CrossOf(const double a[3], const double b[3], const double c[3], double sign, double cross[3])
{
  double u[3], v[3];
  vtkMath::Subtract(b, a, u);
  vtkMath::Subtract(c, a, v);
  vtkMath::Cross(u, v, cross);
  vtkMath::MultiplyScalar(cross, sign);
}

/** The largest ball between planes that enclose a bounded space of size 1. */
class LargestBall
{
public:
  explicit LargestBall(std::vector<Plane> planes)
    : Planes(std::move(planes))
  {
    double nearest = 0.0;
    for (const Plane& plane : this->Planes)
    {
      nearest = std::min(nearest, plane.Offset);
    }
    this->X[3] = nearest - 1.0;
  }

  void Solve();
  double GetRadius() const { return this->X[3]; }
  const double* GetCentre() const { return this->X; }

private:
  double Gap(const Plane& plane, const double x[4]) const
  {
    return plane.Offset - vtkMath::Dot(plane.Normal, x) - x[3];
  }
  double Value(const double x[4], double pull) const;
  bool Step(double pull);

  std::vector<Plane> Planes;
  double X[4] = { 0, 0, 0, 0 }; // centre and radius
};

// Infinite outside.
double LargestBall::Value(const double x[4], double pull) const
{
  double value = -pull * x[3];
  for (const Plane& plane : this->Planes)
  {
    const double gap = this->Gap(plane, x);
    value -= gap > 0.0 ? std::log(gap) : -VTK_DOUBLE_MAX;
  }
  return value;
}

// Of a symmetric matrix, by Cholesky; `x` is the right-hand side, then the solution. False where the
// matrix is not positive definite. (vtkMath::SolveLinearSystem prints where it cannot.)
bool SolvePositive(double (&rows)[4][4], double (&x)[4])
{
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      double rest = rows[i][j];
      for (int k = 0; k < j; ++k)
      {
        rest -= rows[i][k] * rows[j][k];
      }
      if (i == j && !(rest > 0.0))
      {
        return false;
      }
      rows[i][j] = i == j ? std::sqrt(rest) : rest / rows[j][j];
    }
  }
  for (int i = 0; i < 4; ++i)
  {
    for (int k = 0; k < i; ++k)
    {
      x[i] -= rows[i][k] * x[k];
    }
    x[i] /= rows[i][i];
  }
  for (int i = 3; i >= 0; --i)
  {
    for (int k = i + 1; k < 4; ++k)
    {
      x[i] -= rows[k][i] * x[k];
    }
    x[i] /= rows[i][i];
  }
  return true;
}

// One of Newton's; false where it gains nothing.
bool LargestBall::Step(double pull)
{
  double rows[4][4] = {}, down[4] = { 0, 0, 0, pull };
  for (const Plane& plane : this->Planes)
  {
    const double gap = this->Gap(plane, this->X);
    const double slope[4] = { plane.Normal[0] / gap, plane.Normal[1] / gap, plane.Normal[2] / gap,
      1.0 / gap };
    for (int i = 0; i < 4; ++i)
    {
      down[i] -= slope[i];
      for (int j = 0; j < 4; ++j)
      {
        rows[i][j] += slope[i] * slope[j];
      }
    }
  }
  double gain = 0.0;
  double along[4] = { down[0], down[1], down[2], down[3] };
  if (!SolvePositive(rows, along))
  {
    return false;
  }
  for (int i = 0; i < 4; ++i)
  {
    gain += along[i] * down[i];
  }
  const double before = this->Value(this->X, pull);
  for (double step = 1.0; gain > 1e-9 && step > 1e-9; step *= 0.5)
  {
    double x[4];
    for (int i = 0; i < 4; ++i)
    {
      x[i] = this->X[i] + step * along[i];
    }
    if (this->Value(x, pull) < before - 0.1 * step * gain)
    {
      std::copy_n(x, 4, this->X);
      return true;
    }
  }
  return false;
}

void LargestBall::Solve()
{
  for (double pull = 1.0; pull < 1e7 * static_cast<double>(this->Planes.size()); pull *= 10.0)
  {
    for (int step = 0; step < 50 && this->Step(pull); ++step)
    {
    }
  }
}

// In coordinates about `middle` and of size 1.
std::vector<Plane> FindPlanes(const Triangles& triangles, const double (*points)[3], double sign,
  const double middle[3], double size)
{
  std::vector<Plane> planes;
  for (const FaceTriangles::Triangle& t : triangles)
  {
    Plane plane;
    double arm[3];
    CrossOf(points[t[0]], points[t[1]], points[t[2]], sign, plane.Normal);
    vtkMath::Subtract(points[t[0]], middle, arm);
    if (vtkMath::Normalize(plane.Normal) > 1e-12 * size * size)
    {
      plane.Offset = vtkMath::Dot(plane.Normal, arm) / size;
      planes.push_back(plane);
    }
  }
  return planes;
}
}

bool StarCell::FindKernel(const Triangles& triangles, const double (*points)[3], int count,
  double sign, Point& kernel)
{
  const double size = TetrahedralSplit::SizeOf(points, count);
  double middle[3] = { 0, 0, 0 };
  for (int i = 0; i < 3 * count; ++i)
  {
    middle[i % 3] += points[i / 3][i % 3] / count;
  }
  LargestBall ball(FindPlanes(triangles, points, sign, middle, size));
  ball.Solve();
  for (int axis = 0; axis < 3; ++axis)
  {
    kernel[axis] = middle[axis] + size * ball.GetCentre()[axis];
  }
  return ball.GetRadius() > 0.0;
}

bool StarCell::SeesAll(const Triangles& triangles, const double (*points)[3], int count,
  double sign, const Point& kernel)
{
  const double size = TetrahedralSplit::SizeOf(points, count);
  bool all = true, any = false;
  VisitPieces(triangles, points, sign, kernel,
    [&](int a, int b, int c, bool hasVolume)
    {
      double cross[3];
      CrossOf(points[a], points[b], points[c], 1.0, cross);
      all = all && (hasVolume || !(vtkMath::Norm(cross) > 1e-12 * size * size));
      any = any || hasVolume;
    });
  return all && any;
}

std::vector<double> StarCell::FindWeights(
  const Triangles& triangles, const double (*points)[3], int count, const Point& kernel)
{
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  for (int vertex = 0; vertex < count; ++vertex)
  {
    corners->InsertNextPoint(points[vertex]);
  }
  vtkNew<vtkCellArray> faces;
  for (const FaceTriangles::Triangle& t : triangles)
  {
    faces->InsertNextCell({ t[0], t[1], t[2] });
  }
  std::vector<double> weights(count);
  vtkMeanValueCoordinatesInterpolator::ComputeInterpolationWeights(
    kernel.data(), corners, faces, weights.data());
  return weights;
}
