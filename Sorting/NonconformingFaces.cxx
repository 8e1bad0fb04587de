#include "NonconformingFaces.h"

#include "BoxHierarchy.h"
#include "PlanarRegion.h"
#include "vtkMath.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace
{
using CellPair = std::pair<int, int>;

// Share of the mesh's diagonal by which rounding moves points out of a plane.
constexpr double RelativeTolerance = 1e-12;

// Strips of this many tolerances are no contact.
constexpr double ContactWidth = 8.0;

/** Compares the triangles of a boundary; one for all threads. */
class Boundary
{
public:
  explicit Boundary(const CellComplex& complex);
  /** Appends the pairs of cells that touch in triangles `first` and later ones. */
  void FindPairs(int first, std::vector<int>& met, std::vector<CellPair>& pairs) const;

private:
  void SetNormal(std::size_t triangle);
  vtkBoundingBox GetBox(std::size_t triangle) const;
  std::vector<vtkBoundingBox> GetBoxes() const;
  bool DoTouch(int a, int b) const;
  bool IsInPlane(int plane, int triangle) const;
  PlanarRegion::Polygon Project(const double axes[2][3], const double* origin, int triangle) const;
  const double* At(int triangle, int corner) const
  {
    return &this->Complex.Points[3 * size_t(this->Complex.Boundary[triangle].Points[corner])];
  }

  const CellComplex& Complex;
  double Tolerance;
  std::vector<std::array<double, 3>> Normals;
  std::vector<double> Areas;
  BoxHierarchy Boxes;
};

//------------------------------------------------------------------------------
Boundary::Boundary(const CellComplex& complex)
  : Complex(complex)
  , Tolerance(RelativeTolerance * complex.GetSize())
  , Normals(complex.Boundary.size())
  , Areas(complex.Boundary.size())
  , Boxes(this->GetBoxes())
{
  for (std::size_t triangle = 0; triangle < complex.Boundary.size(); ++triangle)
  {
    this->SetNormal(triangle);
  }
}

//------------------------------------------------------------------------------
void Boundary::SetNormal(std::size_t triangle)
{
  double a[3], b[3];
  vtkMath::Subtract(this->At(triangle, 1), this->At(triangle, 0), a);
  vtkMath::Subtract(this->At(triangle, 2), this->At(triangle, 0), b);
  vtkMath::Cross(a, b, this->Normals[triangle].data());
  this->Areas[triangle] = vtkMath::Normalize(this->Normals[triangle].data());
}

//------------------------------------------------------------------------------
vtkBoundingBox Boundary::GetBox(std::size_t triangle) const
{
  vtkBoundingBox box;
  for (int corner = 0; corner < 3; ++corner)
  {
    const double* x = this->At(triangle, corner);
    box.AddPoint(x[0], x[1], x[2]);
  }
  box.Inflate(this->Tolerance);
  return box;
}

//------------------------------------------------------------------------------
std::vector<vtkBoundingBox> Boundary::GetBoxes() const
{
  std::vector<vtkBoundingBox> boxes;
  for (std::size_t triangle = 0; triangle < this->Complex.Boundary.size(); ++triangle)
  {
    boxes.push_back(this->GetBox(triangle));
  }
  return boxes;
}

//------------------------------------------------------------------------------
void Boundary::FindPairs(int first, std::vector<int>& met, std::vector<CellPair>& pairs) const
{
  this->Boxes.FindMet(this->GetBox(first), met);
  for (const int other : met)
  {
    if (other > first && this->DoTouch(first, other))
    {
      pairs.push_back(
        std::minmax(this->Complex.Boundary[first].Cell, this->Complex.Boundary[other].Cell));
    }
  }
}

//------------------------------------------------------------------------------
bool Boundary::DoTouch(int a, int b) const
{
  // The larger triangle has the surer normal.
  const int plane = this->Areas[a] > this->Areas[b] ? a : b;
  const int other = plane == a ? b : a;
  const double* normal = this->Normals[plane].data();
  if (!(vtkMath::Dot(normal, this->Normals[other].data()) < 0.0) ||
      this->Complex.Boundary[a].Cell == this->Complex.Boundary[b].Cell ||
      !this->IsInPlane(plane, other))
  {
    return false;
  }
  double axes[2][3];
  vtkMath::Perpendiculars(normal, axes[0], axes[1], 0.0);
  PlanarRegion::Polygon turned = this->Project(axes, this->At(plane, 0), other);
  std::reverse(turned.begin(), turned.end());
  return PlanarRegion::Overlap(
    this->Project(axes, this->At(plane, 0), plane), turned, ContactWidth * this->Tolerance);
}

//------------------------------------------------------------------------------
bool Boundary::IsInPlane(int plane, int triangle) const
{
  for (int corner = 0; corner < 3; ++corner)
  {
    double relative[3];
    vtkMath::Subtract(this->At(triangle, corner), this->At(plane, 0), relative);
    if (!(std::abs(vtkMath::Dot(relative, this->Normals[plane].data())) <= this->Tolerance))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
PlanarRegion::Polygon Boundary::Project(
  const double axes[2][3], const double* origin, int triangle) const
{
  PlanarRegion::Polygon polygon;
  for (int corner = 0; corner < 3; ++corner)
  {
    double relative[3];
    vtkMath::Subtract(this->At(triangle, corner), origin, relative);
    polygon.push_back(
      PlanarRegion::Point{ { vtkMath::Dot(relative, axes[0]), vtkMath::Dot(relative, axes[1]) } });
  }
  return polygon;
}
}

namespace NonconformingFaces
{
//------------------------------------------------------------------------------
int CountCellPairs(const CellComplex& complex)
{
  const Boundary boundary(complex);
  vtkSMPThreadLocal<std::vector<CellPair>> found;
  vtkSMPTools::For(0, static_cast<vtkIdType>(complex.Boundary.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<int> met;
      for (vtkIdType triangle = begin; triangle < end; ++triangle)
      {
        boundary.FindPairs(static_cast<int>(triangle), met, found.Local());
      }
    });
  std::vector<CellPair> pairs;
  for (const std::vector<CellPair>& part : found)
  {
    pairs.insert(pairs.end(), part.begin(), part.end());
  }
  std::sort(pairs.begin(), pairs.end());
  return static_cast<int>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}
}
