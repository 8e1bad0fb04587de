#include "CurvedError.h"

#include "ConvexCellPoints.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"

#include <cmath>

namespace
{
using Coordinates = CurvedCell::Coordinates;

Coordinates Minus(const Coordinates& a, const Coordinates& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const Coordinates& a, const Coordinates& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The shares of the corners in the foot of `x` on the line, plane or space through them; unchanged
// where these are not that many dimensions.
void FindFoot(const Coordinates* corners, int count, const Coordinates& x, double* shares)
{
  double matrix[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  double side[3] = { 0, 0, 0 }, solution[3];
  double scale = 1.0;
  for (int row = 0; row + 1 < count; ++row)
  {
    const Coordinates arm = Minus(corners[row + 1], corners[0]);
    for (int column = 0; column + 1 < count; ++column)
    {
      matrix[row][column] = Dot(arm, Minus(corners[column + 1], corners[0]));
    }
    side[row] = Dot(arm, Minus(x, corners[0]));
    scale *= matrix[row][row];
  }
  if (!(vtkMath::Determinant3x3(matrix) > 1e-12 * scale))
  {
    return;
  }
  vtkMath::LinearSolve3x3(matrix, side, solution);
  shares[0] = 1.0;
  for (int i = 1; i < count; ++i)
  {
    shares[i] = solution[i - 1];
    shares[0] -= solution[i - 1];
  }
}

double SizeOf(const ConvexCellPoints& points)
{
  vtkBoundingBox box;
  const std::vector<vtkIdType>& canonical = points.GetCanonical();
  for (std::size_t point = 0; point < canonical.size(); ++point)
  {
    double x[3];
    points.Get(static_cast<vtkIdType>(point), x);
    if (canonical[point] >= 0)
    {
      box.AddPoint(x);
    }
  }
  return box.IsValid() ? box.GetDiagonalLength() : 0.0;
}
}

CurvedTolerance::CurvedTolerance(
  const ConvexCellPoints& points, const std::vector<vtkDataArray*>& arrays, double tolerance)
  : Distance(tolerance * SizeOf(points))
{
  const auto count = static_cast<vtkIdType>(points.GetCanonical().size());
  for (vtkDataArray* array : arrays)
  {
    this->NumberOfValues += array->GetNumberOfComponents();
  }
  this->Values.resize(count * this->NumberOfValues);
  int value = 0;
  for (vtkDataArray* array : arrays)
  {
    for (int component = 0; component < array->GetNumberOfComponents(); ++component, ++value)
    {
      double range[2];
      array->GetFiniteRange(range, component);
      const double unit = tolerance * (range[1] - range[0]);
      for (vtkIdType point = 0; point < count && unit > 0.0; ++point)
      {
        this->Values[point * this->NumberOfValues + value] =
          array->GetComponent(point, component) / unit;
      }
    }
  }
}

void CurvedError::Take(const Coordinates& reference, Sample& sample)
{
  sample.X = this->Cell.Locate(reference);
  const int count = this->Tolerance.GetNumberOfValues();
  sample.Values.assign(count, 0.0);
  vtkIdList* ids = this->Cell.GetIds();
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    const double* values = this->Tolerance.GetValues(ids->GetId(i));
    for (int value = 0; value < count; ++value)
    {
      sample.Values[value] += this->Cell.GetWeights()[i] * values[value];
    }
  }
}

// `shares`: of the corners in the reference coordinates of the place.
bool CurvedError::IsOff(const MarkedEdges::Tetrahedron& tetrahedron, const int* corners, int count,
  const double* shares)
{
  Coordinates reference = { 0, 0, 0 }, x[4];
  double feet[4];
  for (int i = 0; i < count; ++i)
  {
    feet[i] = shares[i];
    x[i] = this->Corners[corners[i]].X;
    for (int axis = 0; axis < 3; ++axis)
    {
      reference[axis] += shares[i] * tetrahedron.References[corners[i]][axis];
    }
  }
  this->Take(reference, this->Place);
  FindFoot(x, count, this->Place.X, feet);
  Coordinates gap = this->Place.X;
  std::vector<double>& values = this->Place.Values;
  for (int i = 0; i < count; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      gap[axis] -= feet[i] * x[i][axis];
    }
    for (std::size_t value = 0; value < values.size(); ++value)
    {
      values[value] -= feet[i] * this->Corners[corners[i]].Values[value];
    }
  }
  const auto isLarge = [](double value) { return std::abs(value) > 1.0; };
  return std::sqrt(Dot(gap, gap)) > this->Tolerance.GetDistance() ||
         std::any_of(values.begin(), values.end(), isLarge);
}

bool CurvedError::IsCurved(const MarkedEdges::Tetrahedron& tetrahedron, int edge, bool closely)
{
  this->Cell.Take(tetrahedron.Cell);
  for (const int end : MarkedEdges::Ends[edge])
  {
    this->Take(tetrahedron.References[end], this->Corners[end]);
  }
  // The middle first: where one is off it mostly is.
  constexpr int eighths[7] = { 4, 2, 6, 1, 3, 5, 7 };
  return std::any_of(eighths, eighths + (closely ? 7 : 3),
    [&](int eighth)
    {
      const double shares[2] = { 1.0 - eighth / 8.0, eighth / 8.0 };
      return this->IsOff(tetrahedron, MarkedEdges::Ends[edge], 2, shares);
    });
}

double CurvedError::SquaredLength(int a, int b) const
{
  const Coordinates along = Minus(this->Corners[a].X, this->Corners[b].X);
  return Dot(along, along);
}

int CurvedError::FindLongestOfCurved(const MarkedEdges::Tetrahedron& tetrahedron)
{
  constexpr int faces[5][4] = { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 }, { 0, 1, 2, 3 } };
  this->Cell.Take(tetrahedron.Cell);
  for (int corner = 0; corner < 4; ++corner)
  {
    this->Take(tetrahedron.References[corner], this->Corners[corner]);
  }
  int longest = -1;
  double length = 0.0;
  for (int left = 0; left < 5 && longest < 0; ++left)
  {
    const int count = left < 4 ? 3 : 4;
    const double shares[4] = { 1.0 / count, 1.0 / count, 1.0 / count, 1.0 / count };
    if (!this->IsOff(tetrahedron, faces[left], count, shares))
    {
      continue;
    }
    for (int edge = 0; edge < 6; ++edge)
    {
      const int a = MarkedEdges::Ends[edge][0], b = MarkedEdges::Ends[edge][1];
      const bool belongs = a != left && b != left && tetrahedron.Ids[a] != tetrahedron.Ids[b];
      if (belongs && this->SquaredLength(a, b) > length)
      {
        longest = edge;
        length = this->SquaredLength(a, b);
      }
    }
  }
  return longest;
}
