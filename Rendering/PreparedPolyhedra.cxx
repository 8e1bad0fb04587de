#include "PreparedPolyhedra.h"

#include "FrameStatistics.h"
#include "PreparedVolume.h"

//------------------------------------------------------------------------------
void PreparedPolyhedra::Prepare(
  const PreparedVolume& prepared, const ConvexCellSelection::Emptiness& isEmpty,
  const ConvexCellBuffers::Progress& report)
{
  this->Buffers.Prepare(prepared, report);
  if (this->SelectionTime < this->Buffers.GetCellsTime() ||
      this->SelectionTime < prepared.FunctionTime)
  {
    this->Selection.Classify(this->Buffers.GetCells().Corners, prepared.Scalars, isEmpty);
    this->SelectionTime.Modified();
  }
}

//------------------------------------------------------------------------------
void PreparedPolyhedra::FillStatistics(FrameStatistics& statistics) const
{
  statistics.CellsSkippedTransparent = this->Selection.NumberOfTransparentCells;
  statistics.CellsSkippedInvalid += this->Selection.NumberOfInvalidCells;
  statistics.CellsDrawn = static_cast<vtkIdType>(this->Selection.DrawnCells.size());
}

//------------------------------------------------------------------------------
std::string PreparedPolyhedra::GetFlatCellsMessage() const
{
  return std::to_string(this->GetNumberOfFlatCells()) +
         " cells are too small beside the whole mesh for its float coordinates: they are not "
         "drawn; render their part of the mesh on its own.";
}

//------------------------------------------------------------------------------
std::string PreparedPolyhedra::GetFailureMessage(const std::string& reason) const
{
  return std::to_string(this->Buffers.GetCells().GetNumberOfCells()) +
         " cells cannot be drawn: " + reason + "; draw fewer cells.";
}
