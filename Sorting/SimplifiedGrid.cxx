#include "SimplifiedGrid.h"

#include "CarriedData.h"
#include "NearestPlace.h"
#include "TetrahedraSimplification.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
// The tetrahedra that are left, and their points, by their numbers before.
struct Remainder
{
  std::vector<vtkIdType> Tetrahedra;
  std::vector<vtkIdType> Points;
  std::vector<vtkIdType> NumberOf; // by point before; -1 where it is gone

  explicit Remainder(const CollapsibleMesh& mesh)
    : NumberOf(static_cast<size_t>(mesh.GetNumberOfPoints()), -1)
  {
    for (int t = 0; t < mesh.GetNumberOfTetrahedra(); ++t)
    {
      if (mesh.IsAlive(t))
      {
        this->Tetrahedra.push_back(t);
        for (const int point : mesh.Get(t))
        {
          this->NumberOf[point] = 0;
        }
      }
    }
    for (int point = 0; point < mesh.GetNumberOfPoints(); ++point)
    {
      if (this->NumberOf[point] == 0)
      {
        this->NumberOf[point] = static_cast<vtkIdType>(this->Points.size());
        this->Points.push_back(point);
      }
    }
  }
};

void FillGeometry(const CollapsibleMesh& mesh, const Remainder& left, vtkUnstructuredGrid* grid,
  vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  points->SetNumberOfPoints(static_cast<vtkIdType>(left.Points.size()));
  for (size_t i = 0; i < left.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), grid->GetPoint(left.Points[i]));
  }
  output->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  for (const vtkIdType t : left.Tetrahedra)
  {
    vtkIdType ids[4];
    const CollapsibleMesh::Tetrahedron& corners = mesh.Get(static_cast<int>(t));
    std::transform(
      corners.begin(), corners.end(), ids, [&left](int point) { return left.NumberOf[point]; });
    cells->InsertNextCell(4, ids);
  }
  output->SetCells(VTK_TETRA, cells);
}

vtkSmartPointer<vtkDataArray> MakeScalars(
  const std::vector<double>& values, const Remainder& left, vtkDataArray* original)
{
  vtkSmartPointer<vtkDataArray> array;
  if (original->GetDataType() == VTK_DOUBLE)
  {
    array = vtkSmartPointer<vtkDoubleArray>::New();
  }
  else
  {
    array = vtkSmartPointer<vtkFloatArray>::New();
  }
  array->SetName(original->GetName());
  array->SetNumberOfTuples(static_cast<vtkIdType>(left.Points.size()));
  for (size_t i = 0; i < left.Points.size(); ++i)
  {
    array->SetTuple1(static_cast<vtkIdType>(i), values[left.Points[i]]);
  }
  return array;
}
}

namespace SimplifiedGrid
{
//------------------------------------------------------------------------------
vtkDataArray* Fill(const TetrahedraSimplification& simplification, vtkUnstructuredGrid* grid,
  vtkDataArray* scalars, vtkUnstructuredGrid* output)
{
  const CollapsibleMesh& mesh = simplification.GetMesh();
  const Remainder left(mesh);
  output->Initialize();
  FillGeometry(mesh, left, grid, output);
  vtkPointData* data = output->GetPointData();
  CarriedData::CopyTuples(CarriedData::WholeArrays(grid->GetPointData(), grid->GetNumberOfPoints()),
    data, left.Points.data(), static_cast<vtkIdType>(left.Points.size()));
  CarriedData::CopyTuples(CarriedData::WholeArrays(grid->GetCellData(), grid->GetNumberOfCells()),
    output->GetCellData(), left.Tetrahedra.data(), static_cast<vtkIdType>(left.Tetrahedra.size()));
  const bool isActive = grid->GetPointData()->GetScalars() == scalars;
  const auto shifted = MakeScalars(simplification.GetScalars(), left, scalars);
  if (isActive)
  {
    data->SetScalars(shifted);
  }
  else
  {
    data->AddArray(shifted);
  }
  output->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return shifted;
}

//------------------------------------------------------------------------------
double FindOutsideError(const TetrahedraSimplification& simplification, const double middle[3],
  vtkUnstructuredGrid* grid, vtkDataArray* scalars)
{
  const std::vector<int> outside = simplification.FindOutside();
  if (outside.empty() || grid->GetNumberOfCells() == 0)
  {
    return 0.0;
  }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(grid);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> ids;
  const FieldSamples& samples = simplification.GetSamples();
  double largest = 0.0;
  for (const int sample : outside)
  {
    double x[3], closest[3], distance, weights[4], value = 0.0;
    std::transform(samples.GetPoint(sample), samples.GetPoint(sample) + 3, middle, x,
      [](double relative, double m) { return relative + m; });
    vtkIdType id = -1;
    int part = 0;
    locator->FindClosestPoint(x, closest, cell, id, part, distance);
    // The cell that it hands over may be another one, and VTK's weights leave 0 .. 1 in tetrahedra
    // that are nearly flat.
    grid->GetCellPoints(id, ids);
    double corners[4][3];
    const double* places[4];
    for (int i = 0; i < 4; ++i)
    {
      grid->GetPoint(ids->GetId(i), corners[i]);
      places[i] = corners[i];
    }
    NearestPlace::FindOnTetrahedron(closest, places, weights);
    for (int corner = 0; corner < 4; ++corner)
    {
      value += weights[corner] * scalars->GetTuple1(ids->GetId(corner));
    }
    largest = std::max(largest, std::abs(value - samples.GetValue(sample)));
  }
  return largest;
}
}
