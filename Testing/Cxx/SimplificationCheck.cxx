#include "SimplificationCheck.h"

#include "BoxTree.h"
#include "ConvexCellsTesting.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"
#include "vtkTetrahedraSimplifier.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

using namespace ConvexCellsTesting;

namespace
{
constexpr int FaceOf[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
using Triangle = std::array<vtkIdType, 3>;
using Corners = std::array<vtkIdType, 4>;

Corners CornersOf(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  grid->GetCellPoints(cell, ids);
  Corners corners;
  std::copy_n(ids->begin(), 4, corners.begin());
  return corners;
}

// How many tetrahedra see each triangle turn either way.
std::map<Triangle, std::array<int, 2>> SidesOf(vtkUnstructuredGrid* grid)
{
  std::map<Triangle, std::array<int, 2>> sides;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const Corners corners = CornersOf(grid, cell);
    for (const auto& face : FaceOf)
    {
      Triangle t = { corners[face[0]], corners[face[1]], corners[face[2]] };
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      const int side = t[1] < t[2] ? 0 : 1;
      std::sort(t.begin(), t.end());
      ++sides[t][side];
    }
  }
  return sides;
}

std::vector<Triangle> BoundaryOf(vtkUnstructuredGrid* grid)
{
  std::vector<Triangle> boundary;
  for (const auto& entry : SidesOf(grid))
  {
    if (entry.second[0] + entry.second[1] == 1)
    {
      boundary.push_back(entry.first);
    }
  }
  return boundary;
}

// The nearest place of the boundary: its distance, and the scalar there.
struct Nearest
{
  double Distance = std::numeric_limits<double>::max();
  double Value = 0.0;
};

struct Facet
{
  Triangle Corners;
  BoxTree::Box Box;
};

std::vector<Facet> FacetsOf(vtkUnstructuredGrid* grid)
{
  std::vector<Facet> facets;
  for (const Triangle& t : BoundaryOf(grid))
  {
    facets.push_back({ t, {} });
    for (const vtkIdType corner : t)
    {
      facets.back().Box.Add(PointOf(grid, corner).data());
    }
  }
  return facets;
}

// Not more than of what is in the box but for rounding.
double LeastDistanceSquare(const BoxTree::Box& box, const Point& x)
{
  double square = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double beside = std::max({ 0.0, box.Low[i] - x[i], x[i] - box.High[i] });
    square += beside * beside;
  }
  return square;
}

void Compare(vtkUnstructuredGrid* grid, const Triangle& t, const Point& x, Nearest& nearest)
{
  static const vtkNew<vtkTriangle> triangle;
  for (int i = 0; i < 3; ++i)
  {
    triangle->GetPoints()->SetPoint(i, grid->GetPoint(t[i]));
  }
  double closest[3], place[3], square, weights[3];
  int part;
  triangle->EvaluatePosition(x.data(), closest, part, place, square, weights);
  if (square < nearest.Distance * nearest.Distance)
  {
    nearest.Distance = std::sqrt(square);
    // Of a place beside the triangle the weights are not those of the closest one.
    triangle->EvaluatePosition(closest, nullptr, part, place, square, weights);
    nearest.Value = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      nearest.Value += weights[i] * grid->GetPointData()->GetScalars()->GetTuple1(t[i]);
    }
  }
}

Nearest FindNearest(vtkUnstructuredGrid* grid, const std::vector<Facet>& boundary, const Point& x)
{
  Nearest nearest;
  for (const Facet& facet : boundary)
  {
    if (LeastDistanceSquare(facet.Box, x) * (1.0 - 1e-9) < nearest.Distance * nearest.Distance)
    {
      Compare(grid, facet.Corners, x, nearest);
    }
  }
  return nearest;
}

struct Sample
{
  Point Place;
  double Value;
};

std::vector<Sample> SamplesOf(vtkUnstructuredGrid* grid)
{
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  std::vector<Sample> samples;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    samples.push_back({ PointOf(grid, i), scalars->GetTuple1(i) });
  }
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    Sample middle = { { 0.0, 0.0, 0.0 }, 0.0 };
    for (const vtkIdType id : CornersOf(grid, cell))
    {
      const Point x = PointOf(grid, id);
      for (int axis = 0; axis < 3; ++axis)
      {
        middle.Place[axis] += 0.25 * x[axis];
      }
      middle.Value += 0.25 * scalars->GetTuple1(id);
    }
    samples.push_back(middle);
  }
  return samples;
}

// The scalar of a tetrahedron at a place; false where that is not in it.
bool Interpolate(vtkUnstructuredGrid* grid, const Corners& corners, const Point& x, double& value)
{
  const Point o = PointOf(grid, corners[0]);
  const Point a = Minus(PointOf(grid, corners[1]), o), b = Minus(PointOf(grid, corners[2]), o),
              c = Minus(PointOf(grid, corners[3]), o), d = Minus(x, o);
  const double six = Dot(a, Cross(b, c));
  const double u = Dot(d, Cross(b, c)) / six, v = Dot(d, Cross(c, a)) / six,
               w = Dot(d, Cross(a, b)) / six;
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  value = (1.0 - u - v - w) * scalars->GetTuple1(corners[0]) + u * scalars->GetTuple1(corners[1]) +
          v * scalars->GetTuple1(corners[2]) + w * scalars->GetTuple1(corners[3]);
  return std::min({ u, v, w, 1.0 - u - v - w }) >= -1e-9;
}

// Each sample's error by the tetrahedra that it lies in; -1 where there is none.
std::vector<double> ErrorsInside(vtkUnstructuredGrid* grid, const std::vector<Sample>& samples)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Sample& sample : samples)
  {
    points->InsertNextPoint(sample.Place.data());
  }
  vtkNew<vtkPolyData> set;
  set->SetPoints(points);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(set);
  locator->BuildLocator();
  std::vector<double> errors(samples.size(), -1.0);
  vtkNew<vtkIdList> near;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    grid->GetCellBounds(cell, bounds);
    const Point middle = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
      0.5 * (bounds[4] + bounds[5]) };
    const Point half = Minus({ bounds[1], bounds[3], bounds[5] }, middle);
    locator->FindPointsWithinRadius(1.001 * std::sqrt(Dot(half, half)), middle.data(), near);
    const Corners corners = CornersOf(grid, cell);
    for (const vtkIdType sample : *near)
    {
      double value;
      if (Interpolate(grid, corners, samples[sample].Place, value))
      {
        errors[sample] = std::max(errors[sample], std::abs(value - samples[sample].Value));
      }
    }
  }
  return errors;
}

long long EulerOf(const std::set<Triangle>& triangles, long long tetrahedra)
{
  std::set<vtkIdType> points;
  std::set<std::array<vtkIdType, 2>> edges;
  for (const Triangle& t : triangles)
  {
    points.insert(t.begin(), t.end());
    edges.insert({ t[0], t[1] });
    edges.insert({ t[1], t[2] });
    edges.insert({ t[0], t[2] });
  }
  return static_cast<long long>(points.size()) - static_cast<long long>(edges.size()) +
         static_cast<long long>(triangles.size()) - tetrahedra;
}
}

namespace SimplificationCheck
{
//------------------------------------------------------------------------------
double FieldError(vtkUnstructuredGrid* original, vtkUnstructuredGrid* simplified)
{
  const std::vector<Sample> samples = SamplesOf(original);
  const std::vector<double> errors = ErrorsInside(simplified, samples);
  const std::vector<Facet> boundary = FacetsOf(simplified);
  double range[2], largest = 0.0;
  original->GetPointData()->GetScalars()->GetRange(range);
  for (size_t i = 0; i < samples.size(); ++i)
  {
    const double error =
      errors[i] >= 0.0
        ? errors[i]
        : std::abs(FindNearest(simplified, boundary, samples[i].Place).Value - samples[i].Value);
    largest = std::max(largest, error);
  }
  return largest / (range[1] - range[0]);
}

//------------------------------------------------------------------------------
double BoundaryError(vtkUnstructuredGrid* original, vtkUnstructuredGrid* simplified)
{
  std::vector<Point> places;
  std::set<vtkIdType> corners;
  for (const Triangle& t : BoundaryOf(original))
  {
    corners.insert(t.begin(), t.end());
    Point middle = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < 9; ++i)
    {
      middle[i % 3] += PointOf(original, t[i / 3])[i % 3] / 3.0;
    }
    places.push_back(middle);
  }
  for (const vtkIdType corner : corners)
  {
    places.push_back(PointOf(original, corner));
  }
  const std::vector<Facet> boundary = FacetsOf(simplified);
  double largest = 0.0;
  for (const Point& place : places)
  {
    largest = std::max(largest, FindNearest(simplified, boundary, place).Distance);
  }
  return largest / original->GetLength();
}

//------------------------------------------------------------------------------
Shape Measure(vtkUnstructuredGrid* tetrahedra)
{
  Shape shape;
  std::set<Triangle> all, boundary;
  for (const auto& entry : SidesOf(tetrahedra))
  {
    const int both = entry.second[0] + entry.second[1];
    all.insert(entry.first);
    shape.Wrong += both > 2 || (both == 2 && entry.second[0] != 1);
    if (both == 1)
    {
      boundary.insert(entry.first);
      Point p[3];
      std::transform(entry.first.begin(), entry.first.end(), p,
        [&](vtkIdType id) { return PointOf(tetrahedra, id); });
      shape.BoundaryArea += vtkTriangle::TriangleArea(p[0].data(), p[1].data(), p[2].data());
    }
  }
  for (vtkIdType cell = 0; cell < tetrahedra->GetNumberOfCells(); ++cell)
  {
    const double volume = TetrahedronVolume(tetrahedra, cell);
    shape.Volume += volume;
    shape.Wrong += !(volume > 0.0);
  }
  shape.Euler = EulerOf(all, tetrahedra->GetNumberOfCells());
  shape.BoundaryEuler = EulerOf(boundary, 0);
  return shape;
}

//------------------------------------------------------------------------------
double Check(const std::string& name, vtkUnstructuredGrid* original, double field, double boundary)
{
  vtkNew<vtkTetrahedraSimplifier> filter;
  filter->SetInputData(original);
  filter->SetMaximumFieldError(field);
  filter->SetMaximumBoundaryError(boundary);
  filter->Update();
  vtkUnstructuredGrid* output = filter->GetOutput();
  const double fieldError = FieldError(original, output);
  const double boundaryError = BoundaryError(original, output);
  CHECK(fieldError <= field + 1e-12);
  // What rounding leaves of a plane.
  CHECK(boundaryError <= boundary + 1e-9);
  CHECK(std::abs(boundaryError - filter->GetBoundaryError()) < 1e-9 + 0.5 * boundary);
  CHECK(fieldError <= filter->GetFieldError() + 1e-6);
  const auto before = Measure(original);
  const auto after = Measure(output);
  CHECK_EQUAL(after.Wrong, 0);
  CHECK_EQUAL(after.Euler, before.Euler);
  CHECK_EQUAL(after.BoundaryEuler, before.BoundaryEuler);
  if (boundary == 0.0)
  {
    CHECK(Near(after.Volume, before.Volume, 1e-9));
    CHECK(Near(after.BoundaryArea, before.BoundaryArea, 1e-9));
  }
  const double share =
    static_cast<double>(output->GetNumberOfCells()) / original->GetNumberOfCells();
  std::cout << name << ", bounds " << field << ", " << boundary << ": "
            << original->GetNumberOfCells() << " to " << output->GetNumberOfCells()
            << " tetrahedra (" << 100.0 * share << " %), errors " << fieldError << ", "
            << boundaryError << ", done again " << filter->GetNumberOfRepetitions() << " times\n";
  return share;
}
}
