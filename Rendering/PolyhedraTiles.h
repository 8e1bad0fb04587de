#ifndef PolyhedraTiles_h
#define PolyhedraTiles_h

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

  /// `setScalars` is given the values and whether there is one per cell. The selection must be newer
  /// than scalars and cells.
  template <class Engine, class SetScalars>
  void Update(Engine& engine, const PreparedVolume& prepared, const PreparedPolyhedra& polyhedra,
    const SetScalars& setScalars)
  {
    if (this->CellsTime < polyhedra.Buffers.GetCellsTime())
    {
      engine.SetMesh(prepared.Coordinates.Points, polyhedra.Buffers.GetCells(),
        polyhedra.Buffers.GetPieces(), polyhedra.Buffers.GetPlanes());
      this->CellsTime.Modified();
    }
    if (this->SelectionTime < polyhedra.SelectionTime)
    {
      setScalars(prepared.Scalars.Values, prepared.Scalars.OnePerCell);
      engine.SetDrawn(polyhedra.Selection.DrawnCells);
      this->SelectionTime.Modified();
    }
  }

private:
  vtkTimeStamp CellsTime, SelectionTime;
};

#endif
