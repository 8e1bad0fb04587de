#include "HardConvexCells.h"

#include "CellZoo.h"
#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <vector>

//------------------------------------------------------------------------------
const char* HardConvexCells::GetName(int kind)
{
  static const std::array<const char*, NumberOfKinds> names = { "any", "warped", "on rows", "on columns", "on pixels",
    "beside rows", "of a row", "of a column", "slivers", "flat", "along rows" };
  return names[kind];
}

//------------------------------------------------------------------------------
double HardConvexCells::Random(double least, double greatest)
{
  return std::uniform_real_distribution<double>(least, greatest)(this->Generator);
}

//------------------------------------------------------------------------------
void HardConvexCells::SetAxes(int kind)
{
  const double largest = kind == BesideRows || kind == AlongRows ? 200.0 : 40.0;
  const double whole = 2.0 * std::pow(largest, this->Random(0.0, 1.0)), few = this->Random(0.2, 1.2);
  const double size[3] = { kind == Column ? few : whole, kind == Row ? few : whole, kind == Flat ? 1e-4 : 0.2 };
  const double turn = this->Random(0.0, 6.3), thin = std::pow(10.0, this->Random(-2.0, 0.0)) / whole;
  const double across[2] = { -std::sin(turn), std::cos(turn) };
  for (int i = 0; i < 3; ++i)
  {
    this->Center[i] = i < 2 ? this->Random(-5.0, 133.0) : 0.0;
    for (int k = 0; k < 3; ++k)
    {
      this->Axes[i][k] = (i == k ? 1.0 : this->Random(-0.4, 0.4)) * size[k];
    }
    const double out = (1.0 - thin) * (this->Axes[i][0] * across[0] + this->Axes[i][1] * across[1]);
    for (int k = 0; k < 2 && kind == Slivers; ++k)
    {
      this->Axes[i][k] -= out * across[k];
    }
    this->Axes[i][1] = kind == AlongRows && i != 1 ? 0.0 : this->Axes[i][1];
  }
}

//------------------------------------------------------------------------------
void HardConvexCells::MapPoint(int kind, const double (&reference)[3], double (&point)[3])
{
  for (int k = 0; k < 3; ++k)
  {
    point[k] = this->Center[k];
    for (int i = 0; i < 3; ++i)
    {
      const double bend = kind == Warped ? this->Random(-0.1, 0.1) : 0.0;
      point[k] += (reference[i] - 0.5 + bend) * this->Axes[i][k];
    }
  }
  point[0] = kind == OnColumns || kind == OnPixels ? std::round(point[0]) : point[0];
  point[1] = kind == OnRows || kind == OnPixels ? std::round(point[1]) : point[1];
  if (kind == BesideRows)
  {
    const double digits = std::round(this->Random(-3.0, 3.0));
    point[1] = std::round(point[1]) + digits * std::pow(0.5, std::round(this->Random(13.5, 18.5)));
  }
  if (kind == AlongRows)
  {
    point[1] = std::round(point[1]) + this->Random(-1e-5, 1e-5);
  }
  for (int k = 0; k < 2; ++k)
  {
    point[k] = (point[k] + 0.5) / 64.0 - 1.0;
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> HardConvexCells::Make(int kind, int count, unsigned int seed)
{
  HardConvexCells cells(seed);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("scalar");
  const std::array<int, 4> types = { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON };
  for (int i = 0; i < count; ++i)
  {
    const int type = types[static_cast<std::size_t>(i) % types.size()];
    const CellZoo::Grid reference = CellZoo::Reference(type);
    cells.SetAxes(kind);
    std::vector<vtkIdType> ids;
    for (vtkIdType k = 0; k < reference->GetNumberOfPoints(); ++k)
    {
      double from[3], point[3];
      reference->GetPoint(reference->GetCell(0)->GetPointId(static_cast<int>(k)), from);
      cells.MapPoint(kind, from, point);
      ids.push_back(points->InsertNextPoint(point));
      scalars->InsertNextValue(0.5 + 0.2 * point[0] + 0.1 * point[1] + 0.1 * point[2]);
    }
    grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(scalars);
  return grid;
}
