#ifndef PreparedVolume_h
#define PreparedVolume_h

#include "MeshCoordinates.h"
#include "ScalarField.h"
#include "TransferFunction.h"
#include "vtkTimeStamp.h"

class vtkDataArray;
class vtkUnstructuredGrid;

/**
 * @class PreparedVolume
 * @brief What vtkConvexCellMapper's first stages leave for the ordering and the projection.
 *
 * Each part comes with the time when it was built: what was made from it before is out of date.
 */
struct PreparedVolume
{
  /// New cells, and with them new points.
  void TakeCells(vtkUnstructuredGrid* cells)
  {
    this->Cells = cells;
    this->Coordinates.Build(cells);
    this->CellsTime.Modified();
    this->PointsTime.Modified();
  }

  /// The same cells, moved.
  void TakePoints()
  {
    this->Coordinates.Move(this->Cells);
    this->PointsTime.Modified();
  }

  vtkUnstructuredGrid* Cells = nullptr;
  MeshCoordinates Coordinates;
  ScalarField Scalars;
  /// What they were taken from.
  vtkDataArray* Array = nullptr;
  TransferFunction Function;

  vtkTimeStamp CellsTime;
  /// Never older than CellsTime: new cells have new points.
  vtkTimeStamp PointsTime;
  vtkTimeStamp ScalarsTime;
  vtkTimeStamp FunctionTime;
};

#endif
