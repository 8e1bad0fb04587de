// What the tests of vtkConvexCells share: checks that name their line, and meshes from plain lists.
#ifndef ConvexCellsTesting_h
#define ConvexCellsTesting_h

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkConvexCells.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace ConvexCellsTesting
{
using Point = std::array<double, 3>;

inline int& Failures()
{
  static int failures = 0;
  return failures;
}

inline bool Check(bool holds, const char* file, int line, const char* what)
{
  if (!holds && ++Failures() <= 20)
  {
    std::cerr << file << ":" << line << ": not so: " << what << "\n";
  }
  return holds;
}

template <typename A, typename B>
bool CheckEqual(const A& found, const B& expected, const char* file, int line, const char* what)
{
  const bool holds = Check(found == static_cast<A>(expected), file, line, what);
  if (!holds && Failures() <= 20)
  {
    std::cerr << "  found " << found << ", expected " << expected << "\n";
  }
  return holds;
}

inline int Result()
{
  return Failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

inline vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(
  const std::vector<Point>& points, int precision = VTK_DOUBLE)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataType(precision);
  for (const Point& point : points)
  {
    coordinates->InsertNextPoint(point.data());
  }
  grid->SetPoints(coordinates);
  grid->Allocate(16);
  return grid;
}

inline void AddCell(vtkUnstructuredGrid* grid, int type, const std::vector<vtkIdType>& ids)
{
  grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
}

using Faces = std::vector<std::vector<vtkIdType>>;

inline void AddPolyhedron(vtkUnstructuredGrid* grid, const Faces& faces)
{
  vtkNew<vtkIdList> stream;
  stream->InsertNextId(static_cast<vtkIdType>(faces.size()));
  for (const auto& face : faces)
  {
    stream->InsertNextId(static_cast<vtkIdType>(face.size()));
    for (vtkIdType id : face)
    {
      stream->InsertNextId(id);
    }
  }
  grid->InsertNextCell(VTK_POLYHEDRON, stream);
}

// Of a hexahedron's corners in VTK's order, outward.
inline Faces BoxFaces(const std::vector<vtkIdType>& c)
{
  return { { c[0], c[4], c[7], c[3] }, { c[1], c[2], c[6], c[5] }, { c[0], c[1], c[5], c[4] },
    { c[3], c[7], c[6], c[2] }, { c[0], c[3], c[2], c[1] }, { c[4], c[5], c[6], c[7] } };
}

inline vtkSmartPointer<vtkConvexCells> Run(vtkDataObject* input, bool tetrahedraOnly)
{
  auto filter = vtkSmartPointer<vtkConvexCells>::New();
  filter->SetInputDataObject(input);
  filter->SetTetrahedraOnly(tetrahedraOnly);
  filter->Update();
  return filter;
}

inline Point Minus(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point PointOf(vtkUnstructuredGrid* grid, vtkIdType id)
{
  Point x;
  grid->GetPoint(id, x.data());
  return x;
}

inline double TetrahedronVolume(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  grid->GetCellPoints(cell, ids);
  const Point a = PointOf(grid, ids->GetId(0));
  const Point b = Minus(PointOf(grid, ids->GetId(1)), a);
  const Point c = Minus(PointOf(grid, ids->GetId(2)), a);
  const Point d = Minus(PointOf(grid, ids->GetId(3)), a);
  return Dot(Cross(b, c), d) / 6.0;
}

// The sum over a mesh of tetrahedra; NaN where one is not positive.
inline double TotalVolume(vtkUnstructuredGrid* grid)
{
  double total = 0.0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const double volume = TetrahedronVolume(grid, cell);
    total += volume > 0.0 && grid->GetCellType(cell) == VTK_TETRA ? volume : std::nan("");
  }
  return total;
}

// Of any cell, by the faces that VTK gives, each a fan from its smallest id; negative where the
// faces are wound inward.
inline double VolumeWithin(vtkCell* cell)
{
  Point origin, a, b, c;
  cell->GetPoints()->GetPoint(0, origin.data());
  double volume = 0.0;
  for (int index = 0; index < cell->GetNumberOfFaces(); ++index)
  {
    vtkCell* face = cell->GetFace(index);
    const auto count = static_cast<int>(face->GetNumberOfPoints());
    int start = 0;
    for (int i = 1; i < count; ++i)
    {
      start = face->GetPointId(i) < face->GetPointId(start) ? i : start;
    }
    face->GetPoints()->GetPoint(start, a.data());
    for (int i = 1; i + 1 < count; ++i)
    {
      face->GetPoints()->GetPoint((start + i) % count, b.data());
      face->GetPoints()->GetPoint((start + i + 1) % count, c.data());
      volume += Dot(Cross(Minus(a, origin), Minus(b, origin)), Minus(c, origin)) / 6.0;
    }
  }
  return volume;
}

inline double VolumeWithin(vtkUnstructuredGrid* grid)
{
  double volume = 0.0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    volume += VolumeWithin(grid->GetCell(cell));
  }
  return volume;
}

inline vtkIdType CountType(vtkUnstructuredGrid* grid, int type)
{
  vtkIdType count = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    count += grid->GetCellType(cell) == type;
  }
  return count;
}

inline Point Middle(vtkPoints* points)
{
  Point middle = { 0.0, 0.0, 0.0 };
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      middle[axis] += points->GetPoint(i)[axis] / points->GetNumberOfPoints();
    }
  }
  return middle;
}

// By the faces that VTK itself gives for the cell.
inline bool FacesOutward(vtkCell* cell)
{
  const Point middle = Middle(cell->GetPoints());
  for (int index = 0; index < cell->GetNumberOfFaces(); ++index)
  {
    vtkPoints* face = cell->GetFace(index)->GetPoints();
    Point a, b, c;
    face->GetPoint(0, a.data());
    face->GetPoint(1, b.data());
    face->GetPoint(2, c.data());
    if (Dot(Cross(Minus(b, a), Minus(c, a)), Minus(Middle(face), middle)) <= 0.0)
    {
      return false;
    }
  }
  return cell->GetNumberOfFaces() > 0;
}

inline bool Near(double found, double expected, double relative = 1e-12)
{
  return std::abs(found - expected) <= relative * std::abs(expected);
}
}

#define CHECK(condition) ConvexCellsTesting::Check((condition), __FILE__, __LINE__, #condition)
#define CHECK_EQUAL(found, expected) \
  ConvexCellsTesting::CheckEqual((found), (expected), __FILE__, __LINE__, #found " == " #expected)

#endif
