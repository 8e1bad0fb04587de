#include "CurvedCell.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace
{
using TetrahedralSplit::Shape;

// Active, VTK finds them; its own way to make them so is not for threads.
void Carry(vtkDataSetAttributes* from, vtkDataSetAttributes* to, const char* name, int attribute)
{
  if (vtkAbstractArray* array = from->GetAbstractArray(name))
  {
    to->AddArray(array);
    to->SetActiveAttribute(name, attribute);
  }
}

// Points of a quadratic cell; 0 for Lagrange and Bezier cells, which have a degree.
vtkIdType FixedCount(int type)
{
  switch (type)
  {
    case VTK_QUADRATIC_TETRA:
      return 10;
    case VTK_QUADRATIC_HEXAHEDRON:
      return 20;
    case VTK_QUADRATIC_WEDGE:
      return 15;
    case VTK_QUADRATIC_PYRAMID:
      return 13;
    case VTK_TRIQUADRATIC_HEXAHEDRON:
      return 27;
    case VTK_TRIQUADRATIC_PYRAMID:
      return 19;
    case VTK_QUADRATIC_LINEAR_WEDGE:
      return 12;
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
      return 18;
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
      return 24;
    default:
      return 0;
  }
}

// Points of a cell of one degree along all edges.
vtkIdType CountOf(Shape twin, vtkIdType degree)
{
  const vtkIdType triangle = (degree + 1) * (degree + 2) / 2;
  switch (twin)
  {
    case Shape::Tetrahedron:
      return triangle * (degree + 3) / 3;
    case Shape::Wedge:
      return triangle * (degree + 1);
    default:
      return (degree + 1) * (degree + 1) * (degree + 1);
  }
}

bool IsCountOfDegrees(Shape twin, const double degrees[3], vtkIdType count)
{
  const auto isDegree = [](double degree)
  { return degree >= 1.0 && degree <= CurvedCell::MaximumDegree && degree == std::floor(degree); };
  if (!std::all_of(degrees, degrees + 3, isDegree))
  {
    return false;
  }
  const auto r = static_cast<vtkIdType>(degrees[0]), s = static_cast<vtkIdType>(degrees[1]);
  const auto t = static_cast<vtkIdType>(degrees[2]);
  const bool hexahedron = count == (r + 1) * (s + 1) * (t + 1);
  const bool wedge = r == s && count == (r + 1) * (r + 2) / 2 * (t + 1);
  return twin == Shape::Hexahedron ? hexahedron : wedge;
}
}

bool CurvedCell::TwinOf(int type, Shape& twin)
{
  switch (type)
  {
    case VTK_QUADRATIC_TETRA:
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      twin = Shape::Tetrahedron;
      return true;
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
      twin = Shape::Hexahedron;
      return true;
    case VTK_QUADRATIC_WEDGE:
    case VTK_QUADRATIC_LINEAR_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      twin = Shape::Wedge;
      return true;
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_PYRAMID:
      twin = Shape::Pyramid;
      return true;
    default:
      return false;
  }
}

CurvedCell::CurvedCell(vtkUnstructuredGrid* grid)
{
  this->Grid->CopyStructure(grid);
  Carry(grid->GetCellData(), this->Grid->GetCellData(), "HigherOrderDegrees",
    vtkDataSetAttributes::HIGHERORDERDEGREES);
  Carry(grid->GetPointData(), this->Grid->GetPointData(), "RationalWeights",
    vtkDataSetAttributes::RATIONALWEIGHTS);
}

bool CurvedCell::HasRightCount(vtkIdType cell, int type, vtkIdType count) const
{
  Shape twin;
  if (!TwinOf(type, twin))
  {
    return false;
  }
  if (FixedCount(type) > 0)
  {
    return count == FixedCount(type);
  }
  vtkDataArray* degrees = this->Grid->GetCellData()->GetHigherOrderDegrees();
  if (degrees && twin != Shape::Tetrahedron)
  {
    double triple[3] = { 0, 0, 0 };
    const bool fits = degrees->GetNumberOfComponents() == 3 && cell < degrees->GetNumberOfTuples();
    return fits && (degrees->GetTuple(cell, triple), IsCountOfDegrees(twin, triple, count));
  }
  for (int degree = 1; degree <= MaximumDegree; ++degree)
  {
    if (count == CountOf(twin, degree))
    {
      return true;
    }
  }
  return false;
}

void CurvedCell::Take(vtkIdType cell)
{
  if (cell != this->Taken)
  {
    this->Taken = cell;
    this->Grid->GetCell(cell, this->Cell);
    this->Weights.resize(this->Cell->GetNumberOfPoints());
  }
}

CurvedCell::Coordinates CurvedCell::GetCorner(int vertex)
{
  const double* all = this->Cell->GetParametricCoords();
  return { all[3 * vertex], all[3 * vertex + 1], all[3 * vertex + 2] };
}

CurvedCell::Coordinates CurvedCell::Locate(const Coordinates& reference)
{
  Coordinates parametric = reference, x;
  if (this->Cell->GetCellType() == VTK_QUADRATIC_PYRAMID)
  {
    const double width = 1.0 - reference[2];
    parametric[0] = width > 0.0 ? std::min(reference[0] / width, 1.0) : 0.5;
    parametric[1] = width > 0.0 ? std::min(reference[1] / width, 1.0) : 0.5;
  }
  int part = 0;
  // VTK's Bezier simplices share what they compute.
  static std::mutex shared;
  const int type = this->Cell->GetCellType();
  std::unique_lock<std::mutex> lock(shared, std::defer_lock);
  if (type == VTK_BEZIER_TETRAHEDRON || type == VTK_BEZIER_WEDGE)
  {
    lock.lock();
  }
  this->Cell->EvaluateLocation(part, parametric.data(), x.data(), this->Weights.data());
  return x;
}
