#include "DelaunayTest.h"

#include "TetrahedralSplit.h"

#include "vtkSMPTools.h"

#include <atomic>
#include <cmath>
#include <limits>

namespace
{
// A sum of products with the same sum over absolute values beside it.
struct Term
{
  double Value;
  double Magnitude;
};

Term operator+(const Term& a, const Term& b)
{
  return { a.Value + b.Value, a.Magnitude + b.Magnitude };
}

Term operator-(const Term& a, const Term& b)
{
  return { a.Value - b.Value, a.Magnitude + b.Magnitude };
}

Term operator*(const Term& a, const Term& b)
{
  return { a.Value * b.Value, a.Magnitude * b.Magnitude };
}

struct Vector
{
  Term X, Y, Z;
};

Term Difference(double a, double b)
{
  return { a - b, std::abs(a - b) };
}

Vector Between(const double from[3], const double to[3])
{
  return { Difference(to[0], from[0]), Difference(to[1], from[1]), Difference(to[2], from[2]) };
}

Term Square(const Vector& v)
{
  return v.X * v.X + v.Y * v.Y + v.Z * v.Z;
}

Term Determinant(const Vector& a, const Vector& b, const Vector& c)
{
  return a.X * (b.Y * c.Z - b.Z * c.Y) + a.Y * (b.Z * c.X - b.X * c.Z) +
         a.Z * (b.X * c.Y - b.Y * c.X);
}

// The corner that is farthest from the triangle's plane.
const double* FindApex(const double* const (&triangle)[3], const std::vector<double>& corners)
{
  const double* apex = triangle[0];
  double largest = 0.0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
  {
    const double volume = std::abs(
      TetrahedralSplit::SixVolumes(triangle[0], triangle[1], triangle[2], corners.data() + i));
    if (volume > largest)
    {
      largest = volume;
      apex = corners.data() + i;
    }
  }
  return apex;
}

bool IsRegular(const CellComplex& complex, const CellComplex::Contact& contact,
  const std::vector<double> (&corners)[2])
{
  const double* triangle[3];
  for (int i = 0; i < 3; ++i)
  {
    triangle[i] = complex.Points.data() + 3 * static_cast<std::size_t>(contact.Points[i]);
  }
  return DelaunayTest::IsStrictlyOutside(triangle[0], triangle[1], triangle[2],
    FindApex(triangle, corners[0]), FindApex(triangle, corners[1]));
}
}

//------------------------------------------------------------------------------
bool DelaunayTest::IsStrictlyOutside(
  const double p0[3], const double p1[3], const double p2[3], const double a[3], const double b[3])
{
  const Vector u = Between(p0, p1), v = Between(p0, p2), w = Between(p0, a), x = Between(p0, b);
  // By Cramer's rule, volume * h(x), where h is linear and is |u|^2 at u, |v|^2 at v, |w|^2 at w.
  const Term volume = Determinant(u, v, w);
  const Term lifted = Square(u) * Determinant(x, v, w) + Square(v) * Determinant(u, x, w) +
                      Square(w) * Determinant(u, v, x);
  const Term difference = volume * Square(x) - lifted;
  // Each product of the sum passes through at most 5 differences, 3 roundings of a square, 5 of a
  // determinant and 4 more; the magnitudes are rounded as often.
  constexpr double bound = 18.0 * std::numeric_limits<double>::epsilon();
  const double sign = TetrahedralSplit::SixVolumes(p0, p1, p2, a);
  return sign != 0.0 &&
         (sign > 0.0 ? difference.Value : -difference.Value) > bound * difference.Magnitude;
}

//------------------------------------------------------------------------------
int DelaunayTest::CountIrregularContacts(
  const CellComplex& complex, const CornersOf& cornersOf, const IsCospherical& isCospherical)
{
  std::atomic<int> count(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(complex.Contacts.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> corners[2];
      int irregular = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const int* cells = complex.Contacts[i].Cells;
        bool regular = isCospherical(cells[0]) && isCospherical(cells[1]);
        if (regular)
        {
          cornersOf(cells[0], corners[0]);
          cornersOf(cells[1], corners[1]);
          regular = IsRegular(complex, complex.Contacts[i], corners);
        }
        irregular += regular ? 0 : 1;
      }
      count += irregular;
    });
  return count;
}
