#include "CellComplexBuilder.h"

#include "ExactOrientation.h"
#include "NonconformingFaces.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <tuple>

namespace
{
auto KeyOf(const FaceTriangle& t)
{
  return std::make_tuple(t.Points[1], t.Points[2]);
}

// Corners in a row span no plane: every point is on it.
bool HasArea(const double* a, const double* b, const double* c)
{
  const double axes[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  return std::any_of(axes, axes + 3,
    [&](const double(&axis)[3]) { return ExactOrientation::SideOfDirection(a, b, c, axis) != 0; });
}

// Share of the mesh's diagonal by which rounding warps a face.
constexpr double PlanarTolerance = 1e-12;

bool IsInPlane(const double* points, const int triangle[3], int point, double tolerance)
{
  const double *a = points + 3LL * triangle[0], *b = points + 3LL * triangle[1],
               *c = points + 3LL * triangle[2], *p = points + 3LL * point;
  if (ExactOrientation::SideOfPoint(a, b, c, p) == 0)
  {
    return true;
  }
  double u[3], v[3], w[3], normal[3];
  vtkMath::Subtract(b, a, u);
  vtkMath::Subtract(c, a, v);
  vtkMath::Subtract(p, a, w);
  vtkMath::Cross(u, v, normal);
  return std::abs(vtkMath::Dot(normal, w)) <= tolerance * vtkMath::Norm(normal);
}
}

//------------------------------------------------------------------------------
void CellComplexBuilder::Build(const std::vector<FaceTriangle>& triangles, CellComplex& complex)
{
  CellComplexBuilder builder(triangles, complex);
  builder.Match(false);
  builder.Match(true);
  builder.DropCoplanarContacts();
  complex.NumberOfNonconformingPairs = NonconformingFaces::CountCellPairs(complex);
}

//------------------------------------------------------------------------------
CellComplexBuilder::CellComplexBuilder(
  const std::vector<FaceTriangle>& triangles, CellComplex& complex)
  : Complex(complex)
{
  this->FillBins(triangles);
}

//------------------------------------------------------------------------------
void CellComplexBuilder::FillBins(const std::vector<FaceTriangle>& triangles)
{
  const int points = static_cast<int>(this->Complex.Points.size() / 3);
  const auto count = static_cast<vtkIdType>(triangles.size());
  std::unique_ptr<std::atomic<int>[]> next(new std::atomic<int>[points + 1]());
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        next[triangles[i].Points[0]].fetch_add(1, std::memory_order_relaxed);
      }
    });
  this->Bins.assign(points + 1, 0);
  for (int point = 0; point < points; ++point)
  {
    this->Bins[point + 1] = this->Bins[point] + next[point].load();
    next[point].store(this->Bins[point]);
  }
  this->Sorted.resize(triangles.size());
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const FaceTriangle& t = triangles[i];
        this->Sorted[next[t.Points[0]].fetch_add(1, std::memory_order_relaxed)] = t;
      }
    });
  vtkSMPTools::For(0, points,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        // The cell makes the order, and with it the result, the same in every run.
        std::sort(&this->Sorted[0] + this->Bins[point], &this->Sorted[0] + this->Bins[point + 1],
          [](const FaceTriangle& a, const FaceTriangle& b)
          {
            return std::make_tuple(a.Points[1], a.Points[2], a.Cell) <
                   std::make_tuple(b.Points[1], b.Points[2], b.Cell);
          });
      }
    });
}

//------------------------------------------------------------------------------
void CellComplexBuilder::Match(bool store)
{
  const int points = static_cast<int>(this->Bins.size()) - 1;
  if (!store)
  {
    this->Offsets.assign(points + 1, Counts());
  }
  vtkSMPTools::For(0, points,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        const Counts found =
          this->MatchBin(static_cast<int>(point), store ? this->Offsets[point] : Counts(), store);
        if (!store)
        {
          this->Offsets[point] = found;
        }
      }
    });
  if (store)
  {
    return;
  }
  Counts sum;
  for (Counts& offset : this->Offsets)
  {
    const Counts found = offset;
    offset = sum;
    sum.Contacts += found.Contacts;
    sum.Boundary += found.Boundary;
    sum.NonManifold += found.NonManifold;
    sum.Overlapping += found.Overlapping;
  }
  this->Complex.Contacts.resize(sum.Contacts);
  this->IsPart.resize(sum.Contacts);
  this->Complex.Boundary.resize(sum.Boundary);
  this->Complex.NumberOfNonManifoldFaces = sum.NonManifold;
  this->Complex.NumberOfOverlappingFaces = sum.Overlapping;
}

//------------------------------------------------------------------------------
CellComplexBuilder::Counts CellComplexBuilder::MatchBin(
  int point, const Counts& offsets, bool store)
{
  Counts sum = offsets;
  FaceTriangle* end = this->Sorted.data() + this->Bins[point + 1];
  for (FaceTriangle* begin = this->Sorted.data() + this->Bins[point]; begin != end;)
  {
    FaceTriangle* next = begin;
    while (next != end && KeyOf(*next) == KeyOf(*begin))
    {
      ++next;
    }
    sum = this->MatchGroup(begin, next, sum, store);
    begin = next;
  }
  return sum;
}

//------------------------------------------------------------------------------
CellComplexBuilder::Counts CellComplexBuilder::MatchGroup(
  Range begin, Range end, const Counts& offsets, bool store)
{
  if (end - begin == 2 && (begin[0].Side == 0) != (begin[1].Side == 0))
  {
    // A flat cell lies where its neighbour does not.
    FaceTriangle& flat = begin[0].Side == 0 ? begin[0] : begin[1];
    flat.Side = static_cast<signed char>(-begin[0].Side - begin[1].Side);
  }
  if (end - begin > 1)
  {
    return this->MatchPairs(begin, end, offsets, store);
  }
  Counts sum = offsets;
  if (begin->Side != 0)
  {
    if (store)
    {
      this->StoreBoundary(sum.Boundary, *begin);
    }
    ++sum.Boundary;
  }
  return sum;
}

//------------------------------------------------------------------------------
CellComplexBuilder::Counts CellComplexBuilder::MatchPairs(
  Range begin, Range end, const Counts& offsets, bool store)
{
  Counts sum = offsets;
  for (const FaceTriangle* above = begin; above != end; ++above)
  {
    for (const FaceTriangle* below = begin; below != end; ++below)
    {
      if (above->Side > 0 && below->Side < 0)
      {
        if (store)
        {
          this->StoreContact(sum.Contacts, *above, *below);
        }
        ++sum.Contacts;
      }
    }
  }
  const bool overlap = sum.Contacts == offsets.Contacts && begin->Side != 0;
  for (const FaceTriangle* t = begin; t != end && overlap; ++t)
  {
    if (store)
    {
      this->StoreBoundary(sum.Boundary, *t);
    }
    ++sum.Boundary;
  }
  sum.Overlapping += overlap ? 1 : 0;
  sum.NonManifold += end - begin > 2 ? 1 : 0;
  return sum;
}

//------------------------------------------------------------------------------
void CellComplexBuilder::StoreContact(int at, const FaceTriangle& above, const FaceTriangle& below)
{
  CellComplex::Contact& contact = this->Complex.Contacts[at];
  std::copy_n(above.Points, 3, contact.Points);
  contact.Cells[0] = above.Cell;
  contact.Cells[1] = below.Cell;
  this->IsPart[at] = above.IsPart && below.IsPart;
}

//------------------------------------------------------------------------------
void CellComplexBuilder::StoreBoundary(int at, const FaceTriangle& triangle)
{
  CellComplex::BoundaryTriangle& stored = this->Complex.Boundary[at];
  std::copy_n(triangle.Points, 3, stored.Points);
  stored.Cell = triangle.Cell;
  if (triangle.Side > 0)
  {
    std::swap(stored.Points[1], stored.Points[2]);
  }
}

//------------------------------------------------------------------------------
void CellComplexBuilder::DropCoplanarContacts()
{
  // A planar face of many corners is one contact: those of a fan follow each other, in any order,
  // for they have the smallest id and the cells in common.
  std::vector<CellComplex::Contact>& contacts = this->Complex.Contacts;
  const double* points = this->Complex.Points.data();
  const double tolerance = PlanarTolerance * this->Complex.GetSize();
  const auto isSaidBefore = [&](int at)
  {
    const CellComplex::Contact& c = contacts[at];
    for (int k = at - 1; k >= 0 && contacts[k].Points[0] == c.Points[0]; --k)
    {
      const CellComplex::Contact& other = contacts[k];
      // Ascending ids may turn one triangle of a face the other way.
      if (std::minmax(other.Cells[0], other.Cells[1]) == std::minmax(c.Cells[0], c.Cells[1]) &&
          HasArea(points + 3LL * other.Points[0], points + 3LL * other.Points[1],
            points + 3LL * other.Points[2]) &&
          std::all_of(c.Points, c.Points + 3,
            [&](int p) { return IsInPlane(points, other.Points, p, tolerance); }))
      {
        return true;
      }
    }
    return false;
  };
  std::vector<char> drop(contacts.size(), 0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(contacts.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        drop[i] = this->IsPart[i] && isSaidBefore(static_cast<int>(i));
      }
    });
  size_t kept = 0;
  for (size_t i = 0; i < contacts.size(); ++i)
  {
    if (!drop[i])
    {
      contacts[kept++] = contacts[i];
    }
  }
  contacts.resize(kept);
}
