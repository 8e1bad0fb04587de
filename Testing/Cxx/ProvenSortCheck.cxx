#include "ProvenSortCheck.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkProvenVisibilitySort.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iostream>

namespace
{
// Imaginary cells sort and are never returned; they come after the others.
std::vector<bool> ImaginaryOf(vtkUnstructuredGrid* grid)
{
  std::vector<bool> imaginary(grid->GetNumberOfCells(), false);
  if (vtkDataArray* marks = grid->GetCellData()->GetArray("Imaginary"))
  {
    for (vtkIdType id = 0; id < grid->GetNumberOfCells(); ++id)
    {
      imaginary[id] = marks->GetTuple1(id) != 0.0;
    }
  }
  return imaginary;
}
}

//------------------------------------------------------------------------------
ProvenSortCheck::ProvenSortCheck(const std::string& name, vtkUnstructuredGrid* grid)
  : Name(name)
  , Mesh(grid)
  , Rays(grid, ImaginaryOf(grid))
{
  const std::vector<bool> imaginary = ImaginaryOf(grid);
  this->DrawableCells = std::count(imaginary.begin(), imaginary.end(), false);
}

//------------------------------------------------------------------------------
std::vector<int> ProvenSortCheck::GroupsOf(vtkProvenVisibilitySort* sort) const
{
  std::vector<int> groups(this->Mesh->GetNumberOfCells(), -1);
  vtkCellArray* cells = sort->GetCyclicGroups();
  vtkNew<vtkIdList> ids;
  for (vtkIdType group = 0; group < cells->GetNumberOfCells(); ++group)
  {
    cells->GetCellAtId(group, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      groups.at(ids->GetId(i)) = static_cast<int>(group);
    }
  }
  return groups;
}

//------------------------------------------------------------------------------
bool ProvenSortCheck::HoldsAt(
  vtkProvenVisibilitySort* sort, SortTesting::Eye& eye, const Demands& demands)
{
  const std::vector<vtkIdType> order = SortTesting::OrderOf(sort, this->Mesh, eye);
  const bool permutation = SortTesting::IsPermutation(order, this->DrawableCells);
  const vtkIdType cycles = sort->GetNumberOfCycles();
  const vtkIdType misordered = sort->GetNumberOfMisorderedFaces();
  const bool proven = sort->IsOrderProven();
  RayOrder::Result rays;
  if (permutation)
  {
    const std::vector<int> groups = this->GroupsOf(sort);
    rays = this->Rays.Check(eye.Position, order, groups, this->NumberOfRays);
    this->MostOverlappingRays = std::max(this->MostOverlappingRays, rays.OverlappingRays);
    this->MostCrossingRays = std::max(this->MostCrossingRays, rays.CrossingRays);
    if (cycles > 0)
    {
      const vtkIdType members = static_cast<vtkIdType>(
        std::count_if(groups.begin(), groups.end(), [](int group) { return group >= 0; }));
      this->MostCyclicCells = std::max(this->MostCyclicCells, members);
      this->MostRaysLetOff = std::max(this->MostRaysLetOff, rays.RaysLetOff);
    }
  }
  ++this->Eyes;
  this->ProvenEyes += proven ? 1 : 0;
  this->CyclicEyes += cycles > 0 ? 1 : 0;

  bool holds = permutation && !(proven && (rays.WrongRays > 0 || misordered > 0 || cycles > 0));
  holds = holds && !(demands.RightOnRays && rays.WrongRays > 0);
  holds = holds && !(demands.NoMisorderedFaces && misordered > 0 && cycles == 0);
  holds = holds && !(demands.Proven && !proven);
  if (!holds && !this->Quiet)
  {
    std::cerr << this->Name << ", eye " << eye.Name << " (" << eye.Position[0] << " "
              << eye.Position[1] << " " << eye.Position[2] << " " << eye.Position[3]
              << "): " << (permutation ? "" : "no permutation, ") << cycles << " cycles, "
              << misordered << " misordered faces, " << (proven ? "" : "not ") << "proven, "
              << rays.WrongRays << " of " << rays.Rays << " rays wrong, " << rays.WrongPairs
              << " of " << rays.Pairs << " pairs, cell " << rays.Near << " before " << rays.Far
              << "\n";
  }
  return holds;
}

//------------------------------------------------------------------------------
int ProvenSortCheck::CountFailures(
  vtkProvenVisibilitySort* sort, std::vector<SortTesting::Eye> eyes, const Demands& demands)
{
  int failures = 0;
  for (SortTesting::Eye& eye : eyes)
  {
    failures += this->HoldsAt(sort, eye, demands) ? 0 : 1;
  }
  return failures;
}
