#ifndef TetrahedraTiles_h
#define TetrahedraTiles_h

#include "Tiles/TilesEngine.h"
#include "vtkTimeStamp.h"

#include <vector>

class BackToFrontOrder;
class FrameStatistics;
class TetrahedraSelection;
class VolumeShading;
struct CellProjectionFrame;
struct PreparedVolume;

/**
 * @class TetrahedraTiles
 * @brief Tiles engine for tetrahedra: hands it what a mapper has prepared, as often as that
 * changes.
 */
class TetrahedraTiles
{
public:
  /// Takes cells, scalars and the cells worth drawing where they are newer than what it has.
  void Update(const PreparedVolume& prepared, const TetrahedraSelection& selection,
    const vtkTimeStamp& selectionTime, const TileMesh::Progress& report);

  /// Takes what lights, opens or colours the cells where that is newer than what it has.
  void UpdateShading(const VolumeShading& shading);

  /// Premultiplied RGBA of frame.ImageSize; null where it cannot. `order` null: the engine
  /// finds its own. Sets the frame's RepairedPixels,
  /// CellsSkippedOutside and, less those, CellsDrawn.
  const float* Draw(CellProjectionFrame& frame, const PreparedVolume& prepared,
    const VolumeShading& shading, const BackToFrontOrder* order);

  /// Adds the stages of Draw and what they counted to the frame's statistics.
  bool ReportsStages = false;

  /// Cells that are flat once their points are floats: they are not drawn.
  vtkIdType GetNumberOfFlatCells() const { return this->NumberOfFlatCells; }

private:
  void ReportStages(FrameStatistics& statistics) const;

  TilesEngine Engine;
  vtkIdType NumberOfFlatCells = 0;
  vtkTimeStamp CellsTime, ScalarsTime, SelectionTime, GradientsTime, ColorsTime;
};

#endif
