// The shapes.
#include "SortMeshes.h"

#include "MeshLattice.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace
{
using SortMeshes::Grid;
constexpr double Pi = 3.14159265358979323846;

void AddGear(vtkUnstructuredGrid* grid, double x, double turn)
{
  constexpr int Teeth = 12, PerTooth = 3;
  MeshLattice gear(2, Teeth * PerTooth, 2);
  gear.SetWrap(1);
  gear.SetMask([](int i, int j, int) { return i == 0 || j % PerTooth == 0; });
  gear.SetMap(
    [=](const double u[3], double p[3])
    {
      static const double radii[3] = { 0.3, 0.85, 1.1 };
      const double radius = radii[static_cast<int>(u[0])];
      const double angle = 2.0 * Pi * ((u[1] - 0.5) / PerTooth + turn) / Teeth;
      p[0] = x + radius * std::cos(angle);
      p[1] = radius * std::sin(angle);
      p[2] = 0.2 * (u[2] - 1.0);
    });
  gear.AddTo(grid);
}

// A box whose axis runs from `from` to `to`, as wide as `half` along two more axes.
void AddBar(vtkUnstructuredGrid* grid, const double middle[3], const double axes[3][3])
{
  MeshLattice bar(1, 1, 1);
  bar.SetMap(
    [&](const double u[3], double p[3])
    {
      for (int i = 0; i < 3; ++i)
      {
        p[i] = middle[i];
        for (int axis = 0; axis < 3; ++axis)
        {
          p[i] += (2.0 * u[axis] - 1.0) * axes[axis][i];
        }
      }
    });
  bar.AddTo(grid);
}

void AddBars(vtkUnstructuredGrid* grid, int count, double halfLength)
{
  for (int bar = 0; bar < count; ++bar)
  {
    const double c = std::cos(2.0 * Pi * bar / count), s = std::sin(2.0 * Pi * bar / count);
    const double middle[3] = { c, s, 0.0 };
    const double axes[3][3] = { { -s * halfLength, c * halfLength, 0.3 }, { 0.1 * c, 0.1 * s, 0.0 },
      { 0.0, 0.0, 0.05 } };
    AddBar(grid, middle, axes);
  }
}
}

//------------------------------------------------------------------------------
Grid SortMeshes::Gears()
{
  auto grid = Grid::New();
  AddGear(grid, -1.0, 0.5);
  AddGear(grid, 1.0, 0.0);
  return grid;
}

//------------------------------------------------------------------------------
Grid SortMeshes::SlantedGear()
{
  MeshLattice ring(1, 16, 1);
  ring.SetWrap(1);
  ring.SetMap(
    [](const double u[3], double p[3])
    {
      p[0] = (0.4 + 0.4 * u[0]) * std::cos(2.0 * Pi * u[1] / 16.0);
      p[1] = (0.4 + 0.4 * u[0]) * std::sin(2.0 * Pi * u[1] / 16.0);
      p[2] = 0.3 * (2.0 * u[2] - 1.0);
    });
  Grid grid = ring.Make();
  AddBars(grid, 8, 0.55);
  return grid;
}

//------------------------------------------------------------------------------
Grid SortMeshes::Bars(int count, double halfLength)
{
  auto grid = Grid::New();
  AddBars(grid, count, halfLength);
  return grid;
}

//------------------------------------------------------------------------------
Grid SortMeshes::Slabs()
{
  MeshLattice slabs(4, 4, 3);
  slabs.SetMask([](int, int, int k) { return k != 1; });
  slabs.SetMap(
    [](const double u[3], double p[3])
    {
      static const double z[4] = { -0.5, -0.375, 0.25, 0.5 };
      p[0] = 0.5 * u[0] - 1.0;
      p[1] = 0.5 * u[1] - 1.0;
      p[2] = z[static_cast<int>(u[2])];
    });
  return slabs.Make();
}

//------------------------------------------------------------------------------
Grid SortMeshes::Torus()
{
  MeshLattice torus(2, 10, 16);
  torus.SetWrap(1);
  torus.SetWrap(2);
  torus.SetMap(
    [](const double u[3], double p[3])
    {
      const double minor = 0.15 + 0.1 * u[0], a = 2.0 * Pi * u[1] / 10.0;
      const double b = 2.0 * Pi * u[2] / 16.0;
      const double radius = 1.0 + minor * std::cos(a);
      p[0] = radius * std::cos(b);
      p[1] = radius * std::sin(b);
      p[2] = minor * std::sin(a);
    });
  return torus.Make();
}

//------------------------------------------------------------------------------
Grid SortMeshes::FineRing()
{
  MeshLattice ring(6, 60, 6);
  ring.SetWrap(1);
  ring.SetMap(
    [](const double u[3], double p[3])
    {
      p[0] = (0.6 + 0.06 * u[0]) * std::cos(2.0 * Pi * u[1] / 60.0);
      p[1] = (0.6 + 0.06 * u[0]) * std::sin(2.0 * Pi * u[1] / 60.0);
      p[2] = 0.06 * u[2];
    });
  return Kuhn(ring.Make());
}

//------------------------------------------------------------------------------
Grid SortMeshes::FineBars()
{
  Grid all;
  for (int i = 0; i < 3; ++i)
  {
    const double cosine = std::cos(2.0 * Pi * i / 3.0), sine = std::sin(2.0 * Pi * i / 3.0);
    MeshLattice bar(40, 5, 5);
    bar.SetMap(
      [=](const double u[3], double p[3])
      {
        const double x = 0.055 * (u[0] - 20.0), y = 0.25 + 0.04 * u[1];
        p[0] = cosine * x - sine * y;
        p[1] = sine * x + cosine * y;
        p[2] = 0.3 * x + 0.04 * (u[2] - 2.5);
      });
    const Grid next = Kuhn(bar.Make());
    all = all ? Join(all, next) : next;
  }
  return all;
}

//------------------------------------------------------------------------------
Grid SortMeshes::HollowSphere()
{
  MeshLattice ball(6, 6, 6);
  ball.SetMask(
    [](int i, int j, int k)
    {
      auto outer = [](int n) { return n == 0 || n == 5; };
      return outer(i) || outer(j) || outer(k);
    });
  ball.SetMap(
    [](const double u[3], double p[3])
    {
      double largest = 0.0, square = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        p[i] = (u[i] - 3.0) / 3.0;
        largest = std::max(largest, std::abs(p[i]));
        square += p[i] * p[i];
      }
      for (int i = 0; i < 3; ++i)
      {
        // Half-way to the ball: blown up fully, the corners' cells would fold.
        p[i] *= 0.5 + 0.5 * largest / std::sqrt(square);
      }
    });
  return ball.Make();
}

//------------------------------------------------------------------------------
Grid SortMeshes::Spring()
{
  MeshLattice spring(2, 2, 40);
  spring.SetMap(
    [](const double u[3], double p[3])
    {
      const double angle = 2.0 * Pi * u[2] / 16.0;
      const double radius = 1.0 + 0.15 * (u[0] - 1.0);
      p[0] = radius * std::cos(angle);
      p[1] = radius * std::sin(angle);
      p[2] = 0.15 * (u[1] - 1.0) + 0.1 * angle - 1.0;
    });
  return spring.Make();
}

//------------------------------------------------------------------------------
Grid SortMeshes::LShape()
{
  MeshLattice shape(4, 4, 2);
  shape.SetMask([](int i, int j, int) { return i < 2 || j < 2; });
  return shape.Make();
}

//------------------------------------------------------------------------------
Grid SortMeshes::Checkerboard()
{
  MeshLattice board(4, 4, 4);
  board.SetMask([](int i, int j, int k) { return (i + j + k) % 2 == 0; });
  return board.Make();
}

//------------------------------------------------------------------------------
Grid SortMeshes::Lattice(int cells)
{
  MeshLattice lattice(cells, cells, cells);
  lattice.SetMap(
    [](const double u[3], double p[3])
    {
      for (int i = 0; i < 3; ++i)
      {
        p[i] = 0.125 * u[i];
      }
    });
  return lattice.Make();
}

//------------------------------------------------------------------------------
Grid SortMeshes::JitteredLattice(int cells, double jitter)
{
  auto random = std::make_shared<std::mt19937>(7);
  MeshLattice lattice(cells, cells, cells);
  lattice.SetMap(
    [=](const double u[3], double p[3])
    {
      std::uniform_real_distribution<double> shift(-jitter, jitter);
      for (int i = 0; i < 3; ++i)
      {
        const double move = shift(*random);
        p[i] = u[i] + (u[i] > 0.0 && u[i] < cells ? move : 0.0);
      }
    });
  return lattice.Make();
}

//------------------------------------------------------------------------------
Grid SortMeshes::Prisms()
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  grid->SetPoints(points);
  // Coincident corners are one point to a sort.
  for (int cell = 0; cell < 30; ++cell)
  {
    const int row = cell / 5 % 3, column = cell % 5, layer = cell / 15;
    if (cell % 7 == 3)
    {
      continue;
    }
    vtkIdType ids[12];
    for (int i = 0; i < 12; ++i)
    {
      static const int x[6] = { 2, 1, -1, -2, -1, 1 };
      static const int y[6] = { 0, 1, 1, 0, -1, -1 };
      ids[i] = points->InsertNextPoint(
        3.0 * column + x[i % 6], 2.0 * row + (column % 2) + y[i % 6], 2.0 * layer + 2.0 * (i / 6));
    }
    grid->InsertNextCell(VTK_HEXAGONAL_PRISM, 12, ids);
  }
  return grid;
}

//------------------------------------------------------------------------------
Grid SortMeshes::WarpedThree()
{
  MeshLattice three(1, 3, 1);
  three.SetWrap(1);
  three.SetMap(
    [](const double u[3], double p[3])
    {
      const double radius = 0.2 + u[0];
      const double angle = 2.0 * Pi * u[1] / 3.0 + (u[0] > 0.0 ? 0.2 * (u[2] - 0.5) : 0.0);
      p[0] = radius * std::cos(angle);
      p[1] = radius * std::sin(angle);
      p[2] = u[2];
    });
  return three.Make();
}
