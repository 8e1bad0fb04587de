#include "SortFuzz.h"

#include "ProvenSortCheck.h"
#include "SeedRuns.h"
#include "SortMeshes.h"
#include "vtkDelaunay3D.h"
#include "vtkIdList.h"
#include "vtkMPVOVisibilitySort.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <sstream>

namespace
{
using SortFuzz::Grid;

Grid RandomDelaunay(std::mt19937& random)
{
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const int count = 7 + static_cast<int>(random() % 25);
  for (int i = 0; i < count; ++i)
  {
    double p[3];
    std::generate(p, p + 3, [&] { return coordinate(random); });
    points->InsertNextPoint(p);
  }
  vtkNew<vtkUnstructuredGrid> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkDelaunay3D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->Update();
  return delaunay->GetOutput();
}

Grid RandomLattice(std::mt19937& random)
{
  const int cells = 2 + static_cast<int>(random() % 3);
  // The jitter is the same for the same size: what differs is what is cut out, and the numbering.
  Grid lattice =
    random() % 2 ? SortMeshes::Lattice(cells) : SortMeshes::JitteredLattice(cells, 0.2);
  if (cells < 4 && random() % 2)
  {
    lattice = SortMeshes::Kuhn(lattice);
  }
  return random() % 2 ? lattice
                      : SortMeshes::Shuffled(lattice, static_cast<unsigned int>(random()));
}

constexpr int NumberOfRays = 200;

bool FailsAt(vtkUnstructuredGrid* grid, const std::string& name, const SortTesting::Eye& eye)
{
  vtkNew<vtkMPVOVisibilitySort> sort;
  ProvenSortCheck check(name, grid);
  check.SetNumberOfRays(NumberOfRays);
  check.BeQuiet();
  return check.CountFailures(sort, { eye }, ProvenSortCheck::Demands()) > 0;
}

std::vector<SortTesting::Eye> RandomEyes(vtkUnstructuredGrid* grid, unsigned int seed)
{
  const std::vector<SortTesting::Eye> eyes = SortTesting::Eyes(grid);
  return { eyes[seed % eyes.size()], eyes[(seed / eyes.size() + seed + 7) % eyes.size()] };
}

bool ReportFailures(unsigned int seed)
{
  Grid grid = SortFuzz::Mesh(seed);
  const std::string name = "seed " + std::to_string(seed);
  // Convexified once: that does not depend on the eye.
  vtkNew<vtkMPVOVisibilitySort> sort;
  ProvenSortCheck check(name, grid);
  check.SetNumberOfRays(NumberOfRays);
  for (const SortTesting::Eye& eye : RandomEyes(grid, seed))
  {
    if (check.CountFailures(sort, { eye }, ProvenSortCheck::Demands()) > 0)
    {
      Grid least = SortFuzz::Minimise(
        grid, [&](vtkUnstructuredGrid* part) { return FailsAt(part, name, eye); });
      std::cerr << SortFuzz::Print(least);
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
Grid SortFuzz::Mesh(unsigned int seed)
{
  std::mt19937 random(seed);
  for (;;)
  {
    Grid whole = random() % 2 ? RandomDelaunay(random) : RandomLattice(random);
    const unsigned int cutOut = random() % 70;
    Grid grid = SortMeshes::Select(whole, [&](vtkIdType) { return random() % 100 >= cutOut; });
    if (grid->GetNumberOfCells() >= 10 && grid->GetNumberOfCells() <= 200)
    {
      return grid;
    }
  }
}

//------------------------------------------------------------------------------
Grid SortFuzz::Minimise(
  vtkUnstructuredGrid* grid, const std::function<bool(vtkUnstructuredGrid*)>& fails)
{
  Grid least = grid;
  for (vtkIdType size = std::max<vtkIdType>(1, grid->GetNumberOfCells() / 2); size > 0; size /= 2)
  {
    for (vtkIdType begin = 0; begin < least->GetNumberOfCells();)
    {
      Grid part = SortMeshes::Select(
        least, [=](vtkIdType cell) { return cell < begin || cell >= begin + size; });
      if (part->GetNumberOfCells() > 0 && fails(part))
      {
        least = part;
      }
      else
      {
        begin += size;
      }
    }
  }
  return least;
}

//------------------------------------------------------------------------------
std::string SortFuzz::Print(vtkUnstructuredGrid* grid)
{
  std::ostringstream text;
  text.precision(17);
  text << "const double points[" << grid->GetNumberOfPoints() << "][3] = {";
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    const double* p = grid->GetPoint(id);
    text << (id ? ", { " : " { ") << p[0] << ", " << p[1] << ", " << p[2] << " }";
  }
  text << " };\nconst std::vector<std::vector<vtkIdType>> cells = {";
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    text << (cell ? ", {" : " {");
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      text << (i ? ", " : " ") << ids->GetId(i);
    }
    text << " }";
  }
  text << " };\n";
  return text.str();
}

//------------------------------------------------------------------------------
int SortFuzz::CountFailures(unsigned int first, unsigned int count)
{
  return SeedRuns::CountFailures(first, count, ReportFailures);
}
