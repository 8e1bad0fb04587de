#include "CellZoo.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderWedge.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTriangle.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace
{
using CellZoo::Grid;
using Corners = std::vector<std::array<int, 3>>; // of a cell, in the cube's half steps

const std::array<int, 3> CubeCorners[8] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 },
  { 0, 0, 2 }, { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 2 } };

Corners Pick(const std::vector<int>& vertices)
{
  Corners corners;
  for (const int vertex : vertices)
  {
    corners.push_back(vertex < 8 ? CubeCorners[vertex] : std::array<int, 3>{ 1, 1, 1 });
  }
  return corners;
}

// By linear cell: its corners among the cube's, 8 being the middle.
std::vector<std::vector<int>> PartsOf(int linearType)
{
  switch (linearType)
  {
    case VTK_TETRA:
      return { { 0, 1, 2, 6 }, { 0, 5, 1, 6 }, { 0, 4, 5, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 },
        { 0, 7, 4, 6 } };
    case VTK_WEDGE:
      return { { 0, 1, 2, 4, 5, 6 }, { 0, 2, 3, 4, 6, 7 } };
    case VTK_PYRAMID:
      return { { 0, 3, 7, 4, 8 }, { 1, 5, 6, 2, 8 }, { 0, 4, 5, 1, 8 }, { 3, 2, 6, 7, 8 },
        { 0, 1, 2, 3, 8 }, { 4, 7, 6, 5, 8 } };
    case VTK_VOXEL:
      return { { 0, 1, 3, 2, 4, 5, 7, 6 } };
    default:
      return { { 0, 1, 2, 3, 4, 5, 6, 7 } };
  }
}

struct KindOfCell
{
  int Type;
  int Linear; // the type with the same corners
};
const KindOfCell Kinds[CellZoo::NumberOfKinds] = { { VTK_HEXAHEDRON, VTK_HEXAHEDRON },
  { VTK_VOXEL, VTK_VOXEL }, { VTK_TETRA, VTK_TETRA }, { VTK_WEDGE, VTK_WEDGE },
  { VTK_PYRAMID, VTK_PYRAMID }, { VTK_POLYHEDRON, VTK_HEXAHEDRON },
  { VTK_CONVEX_POINT_SET, VTK_HEXAHEDRON }, { VTK_QUADRATIC_HEXAHEDRON, VTK_HEXAHEDRON },
  { VTK_TRIQUADRATIC_HEXAHEDRON, VTK_HEXAHEDRON },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_HEXAHEDRON },
  { VTK_LAGRANGE_HEXAHEDRON, VTK_HEXAHEDRON }, { VTK_BEZIER_HEXAHEDRON, VTK_HEXAHEDRON },
  { VTK_QUADRATIC_TETRA, VTK_TETRA }, { VTK_LAGRANGE_TETRAHEDRON, VTK_TETRA },
  { VTK_BEZIER_TETRAHEDRON, VTK_TETRA }, { VTK_QUADRATIC_WEDGE, VTK_WEDGE },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_WEDGE }, { VTK_LAGRANGE_WEDGE, VTK_WEDGE },
  { VTK_BEZIER_WEDGE, VTK_WEDGE }, { VTK_QUADRATIC_PYRAMID, VTK_PYRAMID } };

// VTK's class of a Lagrange or Bezier cell knows its points when it knows their number.
vtkSmartPointer<vtkCell> ReferenceCell(int type, int degree)
{
  auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  const vtkIdType n = degree + 1;
  if (auto* hexahedron = vtkHigherOrderHexahedron::SafeDownCast(cell))
  {
    hexahedron->PointIds->SetNumberOfIds(n * n * n);
    hexahedron->Points->SetNumberOfPoints(n * n * n);
    hexahedron->SetOrder(degree, degree, degree);
  }
  else if (auto* wedge = vtkHigherOrderWedge::SafeDownCast(cell))
  {
    wedge->PointIds->SetNumberOfIds(n * (n + 1) / 2 * n);
    wedge->Points->SetNumberOfPoints(n * (n + 1) / 2 * n);
    wedge->SetOrder(degree, degree, degree, n * (n + 1) / 2 * n);
  }
  else if (auto* tetra = vtkHigherOrderTetra::SafeDownCast(cell))
  {
    tetra->PointIds->SetNumberOfIds(n * (n + 1) * (n + 2) / 6);
    tetra->Points->SetNumberOfPoints(n * (n + 1) * (n + 2) / 6);
    tetra->Initialize();
  }
  return cell;
}

/** Adds the cells of cubes to a grid over the half steps of a lattice. */
class Builder
{
public:
  explicit Builder(const int size[3])
    : Row(2 * size[0] + 1)
    , Layer(this->Row * (2 * size[1] + 1))
  {
    this->Points->SetDataTypeToDouble();
    for (int k = 0; k <= 2 * size[2]; ++k)
    {
      for (int j = 0; j <= 2 * size[1]; ++j)
      {
        for (int i = 0; i <= 2 * size[0]; ++i)
        {
          this->Points->InsertNextPoint(0.5 * i, 0.5 * j, 0.5 * k);
        }
      }
    }
    this->Output->SetPoints(this->Points);
    this->Output->Allocate(16);
  }

  void AddCube(int kind, const int cube[3]);
  Grid GetOutput() { return this->Output; }

private:
  vtkIdType IdOf(const int cube[3], const double halfSteps[3]);
  std::vector<vtkIdType> FindIds(
    vtkCell* reference, int linearType, const std::vector<int>& part, const int cube[3]);
  void AddPolyhedron(const std::vector<vtkIdType>& c);

  vtkNew<vtkPoints> Points;
  Grid Output = Grid::New();
  const vtkIdType Row, Layer;
  std::map<std::array<double, 3>, vtkIdType> Others; // that lie between the half steps
};

vtkIdType Builder::IdOf(const int cube[3], const double halfSteps[3])
{
  std::array<double, 3> at;
  bool onLattice = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    at[axis] = 2.0 * cube[axis] + halfSteps[axis];
    onLattice = onLattice && at[axis] == std::floor(at[axis]);
  }
  if (onLattice)
  {
    return static_cast<vtkIdType>(at[0]) + this->Row * static_cast<vtkIdType>(at[1]) +
           this->Layer * static_cast<vtkIdType>(at[2]);
  }
  const auto found = this->Others.find(at);
  if (found != this->Others.end())
  {
    return found->second;
  }
  return this->Others[at] = this->Points->InsertNextPoint(0.5 * at[0], 0.5 * at[1], 0.5 * at[2]);
}

void Builder::AddPolyhedron(const std::vector<vtkIdType>& c)
{
  vtkNew<vtkIdList> stream;
  for (const vtkIdType value : std::vector<vtkIdType>{ 6, 4, c[0], c[4], c[7], c[3], 4, c[1], c[2],
         c[6], c[5], 4, c[0], c[1], c[5], c[4], 4, c[3], c[7], c[6], c[2], 4, c[0], c[3], c[2],
         c[1], 4, c[4], c[5], c[6], c[7] })
  {
    stream->InsertNextId(value);
  }
  this->Output->InsertNextCell(VTK_POLYHEDRON, stream);
}

// Of the corners in the place of a curved cell's point.
std::vector<double> ShareOfCorners(int linearType, const double p[3])
{
  std::vector<double> weights(8, 0.0);
  if (linearType == VTK_WEDGE) // that of VTK has reference coordinates of its own
  {
    const double first = 1.0 - p[0] - p[1], low = 1.0 - p[2];
    return { first * low, p[0] * low, p[1] * low, first * p[2], p[0] * p[2], p[1] * p[2] };
  }
  vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(linearType))
    ->InterpolateFunctions(p, weights.data());
  return weights;
}

// `reference`: null for a linear cell.
std::vector<vtkIdType> Builder::FindIds(
  vtkCell* reference, int linearType, const std::vector<int>& part, const int cube[3])
{
  const Corners corners = Pick(part);
  const auto count = static_cast<vtkIdType>(corners.size());
  std::vector<vtkIdType> ids;
  for (vtkIdType point = 0; point < (reference ? reference->GetNumberOfPoints() : count); ++point)
  {
    std::vector<double> weights(count, 0.0);
    weights[reference ? 0 : point] = 1.0;
    if (reference)
    {
      weights = ShareOfCorners(linearType, reference->GetParametricCoords() + 3 * point);
    }
    double at[3] = { 0, 0, 0 };
    for (vtkIdType i = 0; i < 3 * count; ++i)
    {
      at[i % 3] += weights[i / 3] * corners[i / 3][i % 3];
    }
    ids.push_back(this->IdOf(cube, at));
  }
  return ids;
}

void Builder::AddCube(int kind, const int cube[3])
{
  const KindOfCell& cell = Kinds[kind];
  vtkSmartPointer<vtkCell> reference;
  if (kind >= CellZoo::FirstCurved)
  {
    reference = ReferenceCell(cell.Type, 2);
  }
  for (const std::vector<int>& part : PartsOf(cell.Linear))
  {
    const std::vector<vtkIdType> ids = this->FindIds(reference, cell.Linear, part, cube);
    if (cell.Type == VTK_POLYHEDRON)
    {
      this->AddPolyhedron(ids);
      continue;
    }
    this->Output->InsertNextCell(cell.Type, static_cast<vtkIdType>(ids.size()), ids.data());
  }
}
}

Grid CellZoo::Make(const int size[3], const std::vector<int>& kinds,
  const std::function<double(const double x[3])>& field)
{
  Builder builder(size);
  std::size_t next = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const int cube[3] = { i, j, k };
        builder.AddCube(kinds[next++], cube);
      }
    }
  }
  Grid grid = builder.GetOutput();
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("scalar");
  for (vtkIdType point = 0; point < grid->GetNumberOfPoints(); ++point)
  {
    scalars->InsertNextValue(field(grid->GetPoint(point)));
  }
  grid->GetPointData()->SetScalars(scalars);
  return grid;
}

std::vector<int> CellZoo::AllPairs()
{
  std::vector<int> kinds;
  for (int first = 0; first < NumberOfKinds; ++first)
  {
    for (int second = first; second < NumberOfKinds; ++second)
    {
      kinds.push_back(first);
      kinds.push_back(second);
    }
  }
  return kinds;
}

int CellZoo::TypeOf(int kind)
{
  return Kinds[kind].Type;
}

const std::vector<int>& CellZoo::AllTypes()
{
  static const std::vector<int> types = { VTK_TETRA, VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE,
    VTK_PYRAMID, VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM, VTK_CONVEX_POINT_SET,
    VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE, VTK_QUADRATIC_PYRAMID,
    VTK_TRIQUADRATIC_HEXAHEDRON, VTK_TRIQUADRATIC_PYRAMID, VTK_QUADRATIC_LINEAR_WEDGE,
    VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_LAGRANGE_TETRAHEDRON,
    VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE, VTK_BEZIER_TETRAHEDRON, VTK_BEZIER_HEXAHEDRON,
    VTK_BEZIER_WEDGE };
  return types;
}

Grid CellZoo::Reference(int type, int degree)
{
  auto cell = ReferenceCell(type == VTK_CONVEX_POINT_SET ? VTK_HEXAHEDRON : type, degree);
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    const double* p = cell->GetParametricCoords() + 3 * i;
    // VTK spreads the apex of this one over a square.
    const double width = type == VTK_QUADRATIC_PYRAMID ? 1.0 - p[2] : 1.0;
    ids.push_back(points->InsertNextPoint(p[0] * width, p[1] * width, p[2]));
  }
  grid->SetPoints(points);
  grid->Allocate(1);
  grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
  return grid;
}

CellZoo::FaceUses CellZoo::CountFaceUses(vtkUnstructuredGrid* grid)
{
  std::map<std::array<vtkIdType, 3>, int> uses;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkCell* current = grid->GetCell(cell);
    for (int face = 0; face < current->GetNumberOfFaces(); ++face)
    {
      vtkIdList* list = current->GetFace(face)->GetPointIds();
      std::vector<vtkIdType> ids(list->begin(), list->end());
      std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
      for (std::size_t i = 1; i + 1 < ids.size(); ++i)
      {
        std::array<vtkIdType, 3> triangle = { ids[0], ids[i], ids[i + 1] };
        std::sort(triangle.begin(), triangle.end());
        ++uses[triangle];
      }
    }
  }
  FaceUses counts;
  for (const auto& use : uses)
  {
    counts.Once += use.second == 1;
    counts.Twice += use.second == 2;
    counts.More += use.second > 2;
    double x[3][3];
    for (int corner = 0; corner < 3; ++corner)
    {
      grid->GetPoint(use.first[corner], x[corner]);
    }
    counts.AreaOfOnce += use.second == 1 ? vtkTriangle::TriangleArea(x[0], x[1], x[2]) : 0.0;
  }
  return counts;
}
