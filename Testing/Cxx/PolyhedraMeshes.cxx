#include "PolyhedraMeshes.h"

#include "MeshLattice.h"
#include "SortMeshes.h"
#include "TestMeshes.h"

#include "vtkCellType.h"
#include "vtkConvexCells.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>

namespace
{
using PolyhedraMeshes::Grid;
using Corner = std::array<int, 3>;
using Loop = std::vector<Corner>;

/// Polyhedra whose corners have whole numbers for coordinates, equal ones shared.
class PolyhedronBuilder
{
public:
  PolyhedronBuilder()
  {
    this->Points->SetDataTypeToDouble();
    this->Mesh->SetPoints(this->Points);
  }

  void Add(const std::vector<Loop>& faces)
  {
    vtkNew<vtkIdList> stream;
    stream->InsertNextId(static_cast<vtkIdType>(faces.size()));
    for (const Loop& face : faces)
    {
      stream->InsertNextId(static_cast<vtkIdType>(face.size()));
      for (const Corner& corner : face)
      {
        stream->InsertNextId(this->IdOf(corner));
      }
    }
    this->Mesh->InsertNextCell(VTK_POLYHEDRON, stream);
  }

  Grid Mesh = Grid::New();

private:
  vtkIdType IdOf(const Corner& c)
  {
    const auto found = this->Ids.find(c);
    return found != this->Ids.end()
             ? found->second
             : this->Ids[c] = this->Points->InsertNextPoint(c[0], c[1], c[2]);
  }

  std::map<Corner, vtkIdType> Ids;
  vtkNew<vtkPoints> Points;
};

// About the origin, corners the permutations of (0, 1, 2) with any signs.
std::vector<Loop> FacesOfTruncatedOctahedron()
{
  std::vector<Loop> faces;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int sign : { -1, 1 })
    {
      Loop square(4, Corner{ { 0, 0, 0 } });
      for (int i = 0; i < 4; ++i)
      {
        square[i][axis] = 2 * sign;
        square[i][(axis + 1 + i % 2) % 3] = i < 2 ? 1 : -1;
      }
      faces.push_back(square);
    }
  }
  for (int signs = 0; signs < 8; ++signs)
  {
    Loop hexagon = { { { 0, 1, 2 } }, { { 1, 0, 2 } }, { { 2, 0, 1 } }, { { 2, 1, 0 } },
      { { 1, 2, 0 } }, { { 0, 2, 1 } } };
    for (Corner& corner : hexagon)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        corner[axis] *= (signs >> axis) & 1 ? -1 : 1;
      }
    }
    faces.push_back(hexagon);
  }
  return faces;
}

void SetStretched(vtkUnstructuredGrid* grid, const TestMeshes::Field& field)
{
  TestMeshes::SetField(grid, field);
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  double range[2];
  scalars->GetRange(range);
  for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
  {
    const double share = (scalars->GetComponent(id, 0) - range[0]) / (range[1] - range[0]);
    scalars->SetComponent(id, 0, share);
  }
  scalars->Modified();
}

// Keeps planes planes and makes parallels meet.
void SeeInPerspective(vtkUnstructuredGrid* grid)
{
  PolyhedraMeshes::FitUnitCube(grid);
  vtkPoints* points = grid->GetPoints();
  for (vtkIdType id = 0; id < points->GetNumberOfPoints(); ++id)
  {
    double p[3];
    points->GetPoint(id, p);
    const double w = 1.0 + 0.3 * p[0] - 0.2 * p[1] + 0.25 * p[2];
    points->SetPoint(id, p[0] / w, p[1] / w, p[2] / w);
  }
  PolyhedraMeshes::FitUnitCube(grid);
  PolyhedraMeshes::SetWaves(grid);
}

// Six pyramids about the centre of every hexahedron.
Grid Pyramids(vtkUnstructuredGrid* hexahedra)
{
  static const int sides[6][4] = { { 0, 1, 2, 3 }, { 4, 7, 6, 5 }, { 0, 4, 5, 1 }, { 1, 5, 6, 2 },
    { 2, 6, 7, 3 }, { 3, 7, 4, 0 } };
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->DeepCopy(hexahedra->GetPoints());
  grid->SetPoints(points);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < hexahedra->GetNumberOfCells(); ++cell)
  {
    hexahedra->GetCellPoints(cell, ids);
    double center[3] = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < 24; ++i)
    {
      center[i % 3] += points->GetPoint(ids->GetId(i / 3))[i % 3] / 8.0;
    }
    const vtkIdType apex = points->InsertNextPoint(center);
    for (const auto& side : sides)
    {
      const vtkIdType corners[5] = { ids->GetId(side[0]), ids->GetId(side[1]), ids->GetId(side[2]),
        ids->GetId(side[3]), apex };
      grid->InsertNextCell(VTK_PYRAMID, 5, corners);
    }
  }
  return grid;
}

Grid ReadPentaHexa()
{
  const char* folder = std::getenv("CELLPROJECTION_DATA");
  const std::string file = std::string(folder ? folder : ".") + "/PentaHexa.vtk";
  if (!std::ifstream(file))
  {
    std::cout << "skipped: CELLPROJECTION_DATA names no folder with PentaHexa.vtk\n";
    return nullptr;
  }
  vtkNew<vtkUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}
}

//------------------------------------------------------------------------------
void PolyhedraMeshes::FitUnitCube(vtkUnstructuredGrid* grid)
{
  double bounds[6], center[3];
  grid->GetPoints()->ComputeBounds();
  grid->GetPoints()->GetBounds(bounds);
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    center[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    size = std::max(size, bounds[2 * i + 1] - bounds[2 * i]);
  }
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double p[3];
    grid->GetPoint(id, p);
    grid->GetPoints()->SetPoint(
      id, (p[0] - center[0]) / size, (p[1] - center[1]) / size, (p[2] - center[2]) / size);
  }
  grid->GetPoints()->Modified();
}

//------------------------------------------------------------------------------
void PolyhedraMeshes::SetWaves(vtkUnstructuredGrid* grid)
{
  SetStretched(grid, TestMeshes::Waves);
}

//------------------------------------------------------------------------------
void PolyhedraMeshes::SetLinear(vtkUnstructuredGrid* grid)
{
  SetStretched(grid, [](const double* p) { return 0.4 * p[0] - 0.3 * p[1] + 0.2 * p[2]; });
}

//------------------------------------------------------------------------------
Grid PolyhedraMeshes::Hexahedra(int cells)
{
  Grid grid = SortMeshes::Lattice(cells);
  SeeInPerspective(grid);
  return grid;
}

//------------------------------------------------------------------------------
Grid PolyhedraMeshes::TruncatedOctahedra(int cells)
{
  const std::vector<Loop> faces = FacesOfTruncatedOctahedron();
  PolyhedronBuilder builder;
  for (const int between : { 0, 1 })
  {
    const int count = cells - between;
    for (int cell = 0; cell < count * count * count; ++cell)
    {
      std::vector<Loop> moved = faces;
      const int at[3] = { cell % count, cell / count % count, cell / count / count };
      for (Loop& face : moved)
      {
        for (Corner& corner : face)
        {
          for (int axis = 0; axis < 3; ++axis)
          {
            corner[axis] += 4 * at[axis] + 2 * between;
          }
        }
      }
      builder.Add(moved);
    }
  }
  SeeInPerspective(builder.Mesh);
  return builder.Mesh;
}

//------------------------------------------------------------------------------
Grid PolyhedraMeshes::Prism(int corners, int type)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdList> cell;
  for (int i = 0; i < 2 * corners; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / corners;
    points->InsertNextPoint(0.5 * std::cos(angle), 0.5 * std::sin(angle), i < corners ? -0.5 : 0.5);
    cell->InsertNextId(i);
  }
  if (type == VTK_POLYHEDRON)
  {
    cell->Reset();
    cell->InsertNextId(corners + 2);
    for (int i = -2; i < corners; ++i)
    {
      cell->InsertNextId(i < 0 ? corners : 4);
      for (int k = 0; i < 0 && k < corners; ++k)
      {
        cell->InsertNextId(k + (i + 2) * corners);
      }
      const int next = (i + 1) % corners;
      for (int k = 0; i >= 0 && k < 4; ++k)
      {
        const int loop[4] = { i, next, next + corners, i + corners };
        cell->InsertNextId(loop[i % 2 ? 3 - k : k]);
      }
    }
  }
  grid->SetPoints(points);
  grid->InsertNextCell(type, cell);
  PolyhedraMeshes::SetWaves(grid);
  return grid;
}

//------------------------------------------------------------------------------
Grid PolyhedraMeshes::PentagonalPrisms()
{
  // A pentagon in every sector: the two rims of a ring, and a corner in the middle of the outer
  // one.
  constexpr int count = 8;
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int layer = 0; layer < 3; ++layer)
  {
    for (int i = 0; i < 3 * count; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * (i / 3 + (i % 3 == 2 ? 0.5 : 0.0)) / count;
      const double radius = i % 3 == 0 ? 0.4 : 1.0;
      points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), 0.5 * layer);
    }
  }
  grid->SetPoints(points);
  for (int cell = 0; cell < 2 * count; ++cell)
  {
    const int here = 3 * (cell % count), next = 3 * ((cell + 1) % count);
    const int loop[5] = { here, here + 1, here + 2, next + 1, next };
    vtkIdType ids[10];
    for (int i = 0; i < 10; ++i)
    {
      ids[i] = loop[i % 5] + 3 * count * (cell / count + i / 5);
    }
    grid->InsertNextCell(VTK_PENTAGONAL_PRISM, 10, ids);
  }
  SeeInPerspective(grid);
  return grid;
}

//------------------------------------------------------------------------------
Grid PolyhedraMeshes::Convex(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkConvexCells> cells;
  cells->SetInputData(grid);
  cells->Update();
  return cells->GetOutput();
}

//------------------------------------------------------------------------------
std::vector<PolyhedraMeshes::Entry> PolyhedraMeshes::All()
{
  std::vector<Entry> all = { { "tetrahedra", TestMeshes::Delaunay(60) },
    { "hexahedra", Hexahedra(4) }, { "wedges", SortMeshes::Wedges(Hexahedra(3)) },
    { "pyramids", Pyramids(Hexahedra(3)) }, { "pentagonal prisms", PentagonalPrisms() },
    { "hexagonal prisms", SortMeshes::Prisms() }, { "polyhedra", TruncatedOctahedra(3) },
    { "polyhedron of 9 sides", Prism(7, VTK_POLYHEDRON) },
    { "curvilinear", TestMeshes::Curvilinear(5) } };
  if (const Grid real = ReadPentaHexa())
  {
    all.push_back({ "PentaHexa.vtk", real });
  }
  for (Entry& entry : all)
  {
    FitUnitCube(entry.Mesh);
    SetWaves(entry.Mesh);
  }
  return all;
}
