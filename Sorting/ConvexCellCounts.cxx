#include "ConvexCellCounts.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"

#include <array>

namespace
{
// 3 for what cannot be known.
int DimensionOf(int type)
{
  const auto example = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  return example ? example->GetCellDimension() : 3;
}

void AppendKind(std::string& summary, vtkIdType count, const std::string& what)
{
  if (count > 0)
  {
    summary += (summary.empty() ? "cells left out: " : ", ") + std::to_string(count) + " " + what;
  }
}

void CountOtherTypes(const std::vector<ConvexCellPlan>& plans,
  const std::vector<unsigned char>& types, ConvexCellCounts& counts)
{
  std::array<vtkIdType, 256> cells{};
  for (std::size_t cell = 0; cell < plans.size(); ++cell)
  {
    cells[types[cell]] += plans[cell].Fate == ConvexCellPlan::OtherType;
  }
  for (int type = 0; type < 256; ++type)
  {
    if (cells[type] == 0)
    {
      continue;
    }
    (DimensionOf(type) < 3 ? counts.LowerDimensionalCells : counts.UnsupportedCells) += cells[type];
    AppendKind(counts.LeftOutSummary, cells[type],
      NameOfCellType(type) + " (" + ReasonAgainstType(type) + ")");
  }
}
}

std::string NameOfCellType(int type)
{
  const auto example = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  return example ? example->GetClassName() : "of type " + std::to_string(type);
}

std::string ReasonAgainstType(int type)
{
  const int dimension = DimensionOf(type);
  return dimension < 3 ? std::to_string(dimension) + "-D" : "not supported";
}

ConvexCellCounts CountConvexCells(
  const std::vector<ConvexCellPlan>& plans, const std::vector<unsigned char>& types)
{
  ConvexCellCounts counts;
  std::array<vtkIdType, ConvexCellPlan::Invalid + 1> fates{};
  for (const ConvexCellPlan& plan : plans)
  {
    ++fates[plan.Fate];
    counts.DegenerateCells += plan.Dropped > 0;
    counts.DroppedTetrahedra += plan.Dropped;
    counts.InvertedCells += plan.Inverted;
    counts.FoldedCells += plan.Folded;
    counts.NonConvexCells += plan.NonConvex && plan.Fate == ConvexCellPlan::Tetrahedra;
  }
  counts.ZeroVolumeCells = fates[ConvexCellPlan::ZeroVolume];
  counts.GhostCells = fates[ConvexCellPlan::Ghost] + fates[ConvexCellPlan::Hidden];
  counts.NonFiniteCells = fates[ConvexCellPlan::NonFinite];
  counts.ImaginaryCells = fates[ConvexCellPlan::Imaginary];
  counts.ConcaveCells = fates[ConvexCellPlan::Concave];
  counts.InvalidCells = fates[ConvexCellPlan::Invalid] + fates[ConvexCellPlan::WrongList] +
                        fates[ConvexCellPlan::Open] + fates[ConvexCellPlan::SeveralPieces];
  counts.SkippedCells = static_cast<vtkIdType>(plans.size()) - fates[ConvexCellPlan::Whole] -
                        fates[ConvexCellPlan::Tetrahedra] - counts.ImaginaryCells;
  if (fates[ConvexCellPlan::OtherType] > 0)
  {
    CountOtherTypes(plans, types, counts);
  }
  std::string& summary = counts.LeftOutSummary;
  AppendKind(summary, fates[ConvexCellPlan::WrongList], "vtkPolyhedron (wrong list of faces)");
  AppendKind(summary, fates[ConvexCellPlan::Open], "vtkPolyhedron (open surface)");
  AppendKind(summary, fates[ConvexCellPlan::SeveralPieces], "vtkPolyhedron (several pieces)");
  AppendKind(summary, counts.ConcaveCells, "vtkPolyhedron (concave: no point sees all of it)");
  AppendKind(summary, counts.ZeroVolumeCells, "of zero volume");
  AppendKind(summary, counts.GhostCells, "ghost or hidden");
  AppendKind(summary, counts.NonFiniteCells, "with a point that is not finite");
  AppendKind(summary, fates[ConvexCellPlan::Invalid], "with a wrong list of points");
  return counts;
}
