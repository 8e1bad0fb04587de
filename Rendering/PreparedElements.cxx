#include "PreparedElements.h"

#include "FrameStatistics.h"
#include "PreparedVolume.h"

//------------------------------------------------------------------------------
void PreparedElements::TakeCorners(const PreparedVolume& prepared)
{
  if (this->CornersTime < prepared.CellsTime)
  {
    this->Selection.TakeCorners(prepared.Cells);
    this->CornersTime.Modified();
  }
}

//------------------------------------------------------------------------------
void PreparedElements::Select(const PreparedVolume& prepared)
{
  this->TakeCorners(prepared);
  if (this->SelectionTime < this->CornersTime || this->SelectionTime < prepared.FunctionTime)
  {
    this->Selection.Classify(prepared.Scalars, prepared.Function);
    this->SelectionTime.Modified();
  }
}

//------------------------------------------------------------------------------
void PreparedElements::Select(
  const PreparedVolume& prepared, const TetrahedraSelection::Emptiness& isEmpty)
{
  this->TakeCorners(prepared);
  this->Selection.Classify(prepared.Scalars, isEmpty);
  this->SelectionTime = vtkTimeStamp();
}

//------------------------------------------------------------------------------
void PreparedElements::SelectAll(const PreparedVolume& prepared)
{
  this->TakeCorners(prepared);
  this->Selection.TakeAll();
  this->SelectionTime = vtkTimeStamp();
}

//------------------------------------------------------------------------------
const std::vector<MeshBlock>& PreparedElements::CutIntoBlocks(
  const PreparedVolume& prepared, size_t bytes)
{
  const size_t points = prepared.Coordinates.Points.size() / 4;
  const size_t needed = MeshBlocks::CountBytes(points, prepared.Scalars.Values.size());
  const size_t limit = needed > bytes ? bytes : 0;
  if (limit != this->BlockBytes || this->BlocksTime < this->CornersTime ||
      this->BlocksTime < prepared.ScalarsTime)
  {
    this->Blocks.Blocks.clear();
    if (limit > 0)
    {
      this->Blocks.Build(this->Selection.Corners, points, prepared.Scalars.OnePerCell, limit);
    }
    this->BlockBytes = limit;
    this->BlocksTime.Modified();
  }
  return this->Blocks.Blocks;
}

//------------------------------------------------------------------------------
void PreparedElements::CountTurnedCells(
  const PreparedVolume& prepared, const std::vector<int>* among, const vtkTimeStamp& amongTime)
{
  const std::vector<float>& points = prepared.Coordinates.Points;
  if (this->TurnedTime < prepared.CellsTime)
  {
    this->Turned.TakeSides(points, this->Selection.Corners);
    this->NumberOfTurnedCells = 0;
  }
  else if (this->TurnedTime < prepared.PointsTime || this->TurnedTime < amongTime ||
           this->TurnedAmong != among)
  {
    const std::vector<int>& corners = this->Selection.Corners;
    this->NumberOfTurnedCells =
      among ? this->Turned.Count(points, corners, *among) : this->Turned.Count(points, corners);
  }
  this->TurnedAmong = among;
  this->TurnedTime.Modified();
}

//------------------------------------------------------------------------------
void PreparedElements::FindSeen(const PreparedVolume& prepared, const RasterView& view)
{
  this->CountTurnedCells(prepared);
  this->Cells.Build(
    prepared.Coordinates.Points, this->Selection.Corners, this->Selection, view);
}

//------------------------------------------------------------------------------
void PreparedElements::FillStatistics(FrameStatistics& statistics) const
{
  statistics.CellsSkippedTransparent = this->Selection.NumberOfTransparentCells;
  statistics.CellsSkippedInvalid +=
    this->Selection.NumberOfInvalidCells + this->Cells.NumberOfLostCells;
  statistics.CellsSkippedOutside = this->Cells.NumberOfOutsideCells;
  statistics.CellsDrawn = this->Cells.NumberOfSeenCells;
}

//------------------------------------------------------------------------------
void PreparedElements::Append(vtkIdType cell, std::vector<int>& vertices) const
{
  if (this->Cells.IsSeen(cell))
  {
    const int* corners = &this->Selection.Corners[4 * static_cast<size_t>(cell)];
    vertices.insert(vertices.end(), corners, corners + 4);
    vertices.push_back(static_cast<int>(cell));
  }
}

//------------------------------------------------------------------------------
std::vector<int> PreparedElements::MakeVertices() const
{
  std::vector<int> vertices;
  for (vtkIdType cell = 0; cell < this->Cells.GetNumberOfCells(); ++cell)
  {
    this->Append(cell, vertices);
  }
  return vertices;
}

//------------------------------------------------------------------------------
std::vector<int> PreparedElements::MakeVertices(const std::vector<unsigned int>& cells) const
{
  std::vector<int> vertices;
  vertices.reserve(5 * cells.size());
  for (const unsigned int cell : cells)
  {
    this->Append(cell, vertices);
  }
  return vertices;
}
