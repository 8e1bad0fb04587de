#ifndef PreparedPolyhedra_h
#define PreparedPolyhedra_h

#include "ConvexCellBuffers.h"
#include "ConvexCellSelection.h"
#include "vtkTimeStamp.h"

#include <string>

class FrameStatistics;
struct PreparedVolume;

/**
 * @class PreparedPolyhedra
 * @brief Convex cells and which of them are drawn: what the mappers that do not sort share.
 */
class PreparedPolyhedra
{
public:
  void Prepare(const PreparedVolume& prepared, const ConvexCellSelection::Emptiness& isEmpty,
    const ConvexCellBuffers::Progress& report);
  void FillStatistics(FrameStatistics& statistics) const;

  int GetNumberOfFlatCells() const { return this->Buffers.GetPlanes().NumberOfFlatCells; }
  std::string GetFlatCellsMessage() const;
  std::string GetFailureMessage(const std::string& reason) const;

  ConvexCellBuffers Buffers;
  ConvexCellSelection Selection;
  /// When the selection was made.
  vtkTimeStamp SelectionTime;
};

#endif
