#include "TestMeshes.h"

#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkDelaunay3D.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace
{
TestMeshes::Grid FromImage(const double size[3], const int cells[3])
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(cells[0] + 1, cells[1] + 1, cells[2] + 1);
  image->SetOrigin(-0.5 * size[0], -0.5 * size[1], -0.5 * size[2]);
  image->SetSpacing(size[0] / cells[0], size[1] / cells[1], size[2] / cells[2]);
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(image);
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  return append->GetOutput();
}

// Corners of the unit cube in the order of a hexahedron, then its centre.
vtkSmartPointer<vtkPoints> CubePoints()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double z : { -0.5, 0.5 })
  {
    points->InsertNextPoint(-0.5, -0.5, z);
    points->InsertNextPoint(0.5, -0.5, z);
    points->InsertNextPoint(0.5, 0.5, z);
    points->InsertNextPoint(-0.5, 0.5, z);
  }
  points->InsertNextPoint(0.0, 0.0, 0.0);
  return points;
}

std::vector<std::vector<vtkIdType>> CubeCells(int type)
{
  switch (type)
  {
    case VTK_VOXEL:
      return { { 0, 1, 3, 2, 4, 5, 7, 6 } };
    case VTK_HEXAHEDRON:
      return { { 0, 1, 2, 3, 4, 5, 6, 7 } };
    case VTK_WEDGE:
      return { { 0, 2, 1, 4, 6, 5 }, { 0, 3, 2, 4, 7, 6 } };
    case VTK_PYRAMID:
      return { { 0, 1, 2, 3, 8 }, { 4, 7, 6, 5, 8 }, { 0, 4, 5, 1, 8 }, { 1, 5, 6, 2, 8 },
        { 2, 6, 7, 3, 8 }, { 3, 7, 4, 0, 8 } };
    default:
      return { { 0, 1, 2, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 }, { 0, 7, 4, 6 }, { 0, 4, 5, 6 },
        { 0, 5, 1, 6 } };
  }
}
}

//------------------------------------------------------------------------------
void TestMeshes::SetField(vtkUnstructuredGrid* grid, const Field& field)
{
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("scalar");
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    scalars->InsertNextValue(field(grid->GetPoint(id)));
  }
  grid->GetPointData()->SetScalars(scalars);
}

//------------------------------------------------------------------------------
double TestMeshes::Waves(const double p[3])
{
  return 0.5 + 0.5 * std::sin(7.0 * p[0]) * std::cos(5.0 * p[1]) * std::sin(6.0 * p[2] + 1.0);
}

//------------------------------------------------------------------------------
TestMeshes::Grid TestMeshes::Tetrahedron(const std::vector<int>& numbering)
{
  const double corner[4][3] = { { -0.5, -0.4, -0.3 }, { 0.6, -0.3, 0.1 }, { -0.1, 0.6, -0.2 },
    { 0.05, 0.1, 0.7 } };
  const double scalar[4] = { 0.0, 0.3, 0.7, 1.0 };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("scalar");
  for (const int i : numbering)
  {
    points->InsertNextPoint(corner[i]);
    scalars->InsertNextValue(scalar[i]);
  }
  auto grid = Grid::New();
  grid->SetPoints(points);
  const vtkIdType ids[4] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, ids);
  grid->GetPointData()->SetScalars(scalars);
  return grid;
}

//------------------------------------------------------------------------------
TestMeshes::Grid TestMeshes::Cube(int type)
{
  auto grid = Grid::New();
  grid->SetPoints(CubePoints());
  for (const std::vector<vtkIdType>& cell : CubeCells(type))
  {
    grid->InsertNextCell(type, static_cast<vtkIdType>(cell.size()), cell.data());
  }
  SetField(grid, Waves);
  return grid;
}

//------------------------------------------------------------------------------
TestMeshes::Grid TestMeshes::SixTetrahedra()
{
  return Cube(VTK_TETRA);
}

//------------------------------------------------------------------------------
TestMeshes::Grid TestMeshes::Slab(const double size[3], const int cells[3])
{
  Grid grid = FromImage(size, cells);
  SetField(grid, [](const double*) { return 1.0; });
  return grid;
}

//------------------------------------------------------------------------------
TestMeshes::Grid TestMeshes::JitteredCube(int cells)
{
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int counts[3] = { cells, cells, cells };
  Grid grid = FromImage(size, counts);
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double p[3];
    grid->GetPoint(id, p);
    // Nothing on the cube's faces.
    const double room = 20.0 / cells * (0.25 - p[0] * p[0]) * (0.25 - p[1] * p[1]) *
                        (0.25 - p[2] * p[2]);
    grid->GetPoints()->SetPoint(id, p[0] + room * std::sin(17.0 * id),
      p[1] + room * std::sin(23.0 * id), p[2] + room * std::sin(29.0 * id));
  }
  SetField(grid, Waves);
  return grid;
}

//------------------------------------------------------------------------------
TestMeshes::Grid TestMeshes::Delaunay(int count)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(1);
  auto next = [&random]
  {
    random->Next();
    return random->GetValue() - 0.5;
  };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < count; ++i)
  {
    const double x = next(), y = next(), z = next();
    points->InsertNextPoint(x, y, z);
  }
  vtkNew<vtkUnstructuredGrid> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkDelaunay3D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->Update();
  Grid grid = delaunay->GetOutput();
  SetField(grid, Waves);
  return grid;
}

//------------------------------------------------------------------------------
TestMeshes::Grid TestMeshes::Curvilinear(int cells)
{
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int counts[3] = { cells, cells, cells };
  Grid grid = FromImage(size, counts);
  SetField(grid, Waves);
  vtkPoints* points = grid->GetPoints();
  for (vtkIdType id = 0; id < points->GetNumberOfPoints(); ++id)
  {
    double p[3];
    points->GetPoint(id, p);
    const double angle = 0.5 * p[2];
    const double radius = 1.0 + 0.3 * p[1];
    points->SetPoint(id, radius * p[0] * std::cos(angle) - p[1] * std::sin(angle),
      radius * p[0] * std::sin(angle) + p[1] * std::cos(angle), p[2]);
  }
  return grid;
}
