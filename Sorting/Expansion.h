/**
 * Exact sums and products of doubles: a number as a sum of doubles that do not overlap, smallest
 * first (Shewchuk 1997, section 2; the code is our own). `Capacity` is the most terms it may take.
 */
#ifndef Expansion_h
#define Expansion_h

#include <array>
#include <cmath>

template <int Capacity>
class Expansion
{
public:
  Expansion() = default;

  /** a - b. */
  static Expansion Difference(double a, double b)
  {
    Expansion result;
    result.Add(a);
    result.Add(-b);
    return result;
  }

  /** Adds one double exactly; terms that are zero are left out. */
  void Add(double value)
  {
    int kept = 0;
    for (int i = 0; i < this->Size; ++i)
    {
      const double sum = value + this->Terms[i];
      const double shadow = sum - value;
      const double rest = (value - (sum - shadow)) + (this->Terms[i] - shadow);
      if (rest != 0.0)
      {
        this->Terms[kept++] = rest;
      }
      value = sum;
    }
    if (value != 0.0)
    {
      this->Terms[kept++] = value;
    }
    this->Size = kept;
  }

  template <int Other>
  void Add(const Expansion<Other>& other, double sign = 1.0)
  {
    for (int i = 0; i < other.GetSize(); ++i)
    {
      this->Add(sign * other[i]);
    }
  }

  template <int First, int Second>
  static Expansion Product(const Expansion<First>& a, const Expansion<Second>& b)
  {
    static_assert(2 * First * Second <= Capacity, "the product may have more terms");
    Expansion result;
    for (int i = 0; i < a.GetSize(); ++i)
    {
      for (int j = 0; j < b.GetSize(); ++j)
      {
        const double product = a[i] * b[j];
        result.Add(std::fma(a[i], b[j], -product));
        result.Add(product);
      }
    }
    return result;
  }

  /** The largest term has the sign of the whole. */
  int GetSign() const
  {
    const double last = this->Size == 0 ? 0.0 : this->Terms[this->Size - 1];
    return (last > 0.0) - (last < 0.0);
  }

  int GetSize() const { return this->Size; }
  double operator[](int term) const { return this->Terms[term]; }

private:
  std::array<double, Capacity> Terms;
  int Size = 0;
};

#endif
