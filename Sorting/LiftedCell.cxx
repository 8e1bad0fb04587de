#include "LiftedCell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
constexpr double Epsilon = std::numeric_limits<double>::epsilon();

using Row = std::array<double, 4>; // three coefficients, right side

double Dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Brings the largest coefficient of what is left to the diagonal; returns its size.
double Pivot(Row* rows, int count, int step, int (&columns)[3])
{
  int row = step, column = step;
  for (int i = step; i < count; ++i)
  {
    for (int j = step; j < 3; ++j)
    {
      if (std::abs(rows[i][columns[j]]) > std::abs(rows[row][columns[column]]))
      {
        row = i;
        column = j;
      }
    }
  }
  std::swap(rows[step], rows[row]);
  std::swap(columns[step], columns[column]);
  return std::abs(rows[step][columns[step]]);
}

void Eliminate(Row* rows, int count, int step, const int (&columns)[3])
{
  for (int i = step + 1; i < count; ++i)
  {
    const double factor = rows[i][columns[step]] / rows[step][columns[step]];
    for (int j = step + 1; j < 3; ++j)
    {
      rows[i][columns[j]] -= factor * rows[step][columns[j]];
    }
    rows[i][3] -= factor * rows[step][3];
  }
}

// Solves by the best rows and returns the rank; unknowns beyond it are 0.
int Solve(Row* rows, int count, double x[3])
{
  int columns[3] = { 0, 1, 2 };
  int rank = 0;
  double largest = 0.0;
  while (rank < std::min(count, 3))
  {
    const double pivot = Pivot(rows, count, rank, columns);
    largest = std::max(largest, pivot);
    // Below this a pivot is what two steps of elimination leave of rounding. Also ends on NaN.
    if (!(pivot > 8.0 * Epsilon * largest))
    {
      break;
    }
    Eliminate(rows, count, rank, columns);
    ++rank;
  }
  x[0] = x[1] = x[2] = 0.0;
  for (int i = rank - 1; i >= 0; --i)
  {
    double sum = rows[i][3];
    for (int j = i + 1; j < rank; ++j)
    {
      sum -= rows[i][columns[j]] * x[columns[j]];
    }
    x[columns[i]] = sum / rows[i][columns[i]];
  }
  return rank;
}

// About `origin`, |y|^2 is `gradient`.y + `offset`.
struct LocalFit
{
  double Origin[3];
  double Gradient[3];
  double Offset = 0.0;
  int Rank = 0;
};

void Subtract(const double a[3], const double b[3], double difference[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    difference[axis] = a[axis] - b[axis];
  }
}

LocalFit Interpolate(const double (*corners)[3], int count, Row* rows)
{
  LocalFit fit;
  std::copy_n(corners[0], 3, fit.Origin);
  for (int i = 1; i < count; ++i)
  {
    Row& row = rows[i - 1];
    Subtract(corners[i], fit.Origin, row.data());
    row[3] = Dot(row.data(), row.data());
  }
  fit.Rank = Solve(rows, count - 1, fit.Gradient);
  return fit;
}

LocalFit FitLeastSquares(const double (*corners)[3], int count)
{
  LocalFit fit;
  for (int axis = 0; axis < 3; ++axis)
  {
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
    {
      sum += corners[i][axis];
    }
    fit.Origin[axis] = sum / count;
  }
  Row normal[3] = {};
  for (int i = 0; i < count; ++i)
  {
    double y[3];
    Subtract(corners[i], fit.Origin, y);
    const double square = Dot(y, y);
    fit.Offset += square / count;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        normal[row][column] += y[row] * y[column];
      }
      normal[row][3] += y[row] * square;
    }
  }
  fit.Rank = Solve(normal, 3, fit.Gradient);
  return fit;
}

// Backward error of a solution by elimination (Higham 2002, theorem 9.4: 3 n roundings of the
// factors' magnitude, at most 4 times the matrix's by complete pivoting with n = 3), and the
// roundings of both sides here: under 64 in all.
bool HoldsAtAllCorners(const LocalFit& fit, const double (*corners)[3], int count)
{
  for (int i = 0; i < count; ++i)
  {
    double y[3];
    Subtract(corners[i], fit.Origin, y);
    double terms = Dot(y, y);
    double residual = terms;
    for (int axis = 0; axis < 3; ++axis)
    {
      residual -= fit.Gradient[axis] * y[axis];
      terms += std::abs(fit.Gradient[axis] * y[axis]);
    }
    if (!(std::abs(residual) <= 64.0 * Epsilon * terms))
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
LiftedCell LiftedCell::Fit(const double (*corners)[3], int count)
{
  LiftedCell cell;
  if (count == 0)
  {
    return cell;
  }
  constexpr int small = 8;
  Row onStack[small];
  std::vector<Row> onHeap(count > small ? count : 0);
  LocalFit fit = Interpolate(corners, count, count > small ? onHeap.data() : onStack);
  cell.Cospherical = fit.Rank == 3 && HoldsAtAllCorners(fit, corners, count);
  if (!cell.Cospherical && count > 4)
  {
    fit = FitLeastSquares(corners, count);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    cell.Gradient[axis] = 2.0 * fit.Origin[axis] + fit.Gradient[axis];
  }
  cell.Constant = fit.Offset - Dot(fit.Origin, fit.Origin) - Dot(fit.Gradient, fit.Origin);
  if (!std::isfinite(cell.Constant + cell.Gradient[0] + cell.Gradient[1] + cell.Gradient[2]))
  {
    cell = LiftedCell();
  }
  return cell;
}
