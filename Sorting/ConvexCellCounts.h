/**
 * How many cells met which fate, and one line of text for those that were left out.
 */
#ifndef ConvexCellCounts_h
#define ConvexCellCounts_h

#include "ConvexCellPlan.h"

#include <string>
#include <vector>

/** As vtkConvexCells documents its NumberOf... */
struct ConvexCellCounts
{
  vtkIdType MergedPoints = 0;
  vtkIdType DegenerateCells = 0;
  vtkIdType DroppedTetrahedra = 0;
  vtkIdType InvertedCells = 0;
  vtkIdType FoldedCells = 0;
  vtkIdType NonConvexCells = 0;
  vtkIdType SkippedCells = 0;
  vtkIdType ZeroVolumeCells = 0;
  vtkIdType LowerDimensionalCells = 0;
  vtkIdType UnsupportedCells = 0;
  vtkIdType GhostCells = 0;
  vtkIdType NonFiniteCells = 0;
  vtkIdType ImaginaryCells = 0;
  vtkIdType ConcaveCells = 0;
  vtkIdType CoarseCells = 0;
  vtkIdType InvalidCells = 0;
  std::string LeftOutSummary;
};

/** VTK's name of the class, or the number where it has none. */
std::string NameOfCellType(int type);
/** Why a type is not taken. */
std::string ReasonAgainstType(int type);

/** By input cell: its plan and its VTK type. MergedPoints is not known here. */
ConvexCellCounts CountConvexCells(
  const std::vector<ConvexCellPlan>& plans, const std::vector<unsigned char>& types);

#endif
