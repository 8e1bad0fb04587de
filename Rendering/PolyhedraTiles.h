#ifndef PolyhedraTiles_h
#define PolyhedraTiles_h

#include "FrameStatistics.h"
#include "PreparedPolyhedra.h"
#include "PreparedVolume.h"
#include "Tiles/ConvexTilesFrame.h"
#include "vtkTimeStamp.h"

struct CellProjectionFrame;

/**
 * @class PolyhedraTiles
 * @brief Hands a Tiles engine for convex cells what a mapper has prepared, as often as that changes.
 */
class PolyhedraTiles
{
public:
  static ConvexTilesFrame::Scene DescribeScene(
    const CellProjectionFrame& frame, const PreparedVolume& prepared);

  /// `setScalars` is given the values and whether there is one per cell: where they or the cells are
  /// new, not for a new transfer function.
  template <class Engine, class SetScalars>
  void Update(Engine& engine, const PreparedVolume& prepared, const PreparedPolyhedra& polyhedra,
    const SetScalars& setScalars)
  {
    const bool newCells = this->CellsTime < polyhedra.Buffers.GetCellsTime();
    if (newCells)
    {
      engine.SetMesh(prepared.Coordinates.Points, polyhedra.Buffers.GetCells(),
        polyhedra.Buffers.GetPieces(), polyhedra.Buffers.GetPlanes());
      this->CellsTime.Modified();
    }
    if (newCells || this->ScalarsTime < prepared.ScalarsTime)
    {
      setScalars(prepared.Scalars.Values, prepared.Scalars.OnePerCell);
      this->ScalarsTime.Modified();
    }
    if (newCells || this->SelectionTime < polyhedra.SelectionTime)
    {
      engine.SetDrawn(polyhedra.Selection.DrawnCells);
      this->SelectionTime.Modified();
    }
  }

  /// They mean something else from the next update on.
  void RenewScalars() { this->ScalarsTime = vtkTimeStamp(); }

  /// After a frame of the engine.
  template <class Engine>
  static void FillStatistics(const Engine& engine, FrameStatistics& statistics)
  {
    statistics.CellsSkippedOutside = engine.CountCellsOutside();
    statistics.CellsDrawn -= statistics.CellsSkippedOutside;
  }

private:
  vtkTimeStamp CellsTime, ScalarsTime, SelectionTime;
};

#endif
