#ifndef PreparedElements_h
#define PreparedElements_h

#include "MeshBlocks.h"
#include "ShellCells.h"
#include "TetrahedraSelection.h"
#include "TurnedCells.h"
#include "vtkTimeStamp.h"

#include <vector>

class FrameStatistics;
struct PreparedVolume;
struct RasterView;

/**
 * @class PreparedElements
 * @brief The tetrahedra of a volume, which of them are drawn, and how far they are from the eye.
 */
class PreparedElements
{
public:
  /// Of the transfer function, kept until it, the scalars or the cells change.
  void Select(const PreparedVolume& prepared);
  /// Of anything else; found in every frame.
  void Select(const PreparedVolume& prepared, const TetrahedraSelection::Emptiness& isEmpty);

  /// Their corners alone, for those who select and draw them otherwise.
  void TakeCorners(const PreparedVolume& prepared);

  /// All of them.
  void SelectAll(const PreparedVolume& prepared);

  /// The blocks of a mesh that takes more than `bytes` (0: no limit); empty where it does not.
  const std::vector<MeshBlock>& CutIntoBlocks(const PreparedVolume& prepared, size_t bytes);

  /// After Select, for this view.
  void FindSeen(const PreparedVolume& prepared, const RasterView& view);
  /// The cells that moved points have turned, of all or of these, found at `amongTime`; FindSeen
  /// counts all.
  void CountTurnedCells(const PreparedVolume& prepared, const std::vector<int>* among = nullptr,
    const vtkTimeStamp& amongTime = vtkTimeStamp());
  void FillStatistics(FrameStatistics& statistics) const;

  /// Those that are seen as ElementLists gives them, as they come; these cells.
  std::vector<int> MakeVertices() const;
  std::vector<int> MakeVertices(const std::vector<unsigned int>& cells) const;

  TetrahedraSelection Selection;
  ShellCells Cells;
  /// When the corners were taken.
  vtkTimeStamp CornersTime;
  /// Moved points have turned so many inside out.
  vtkIdType NumberOfTurnedCells = 0;

private:
  void Append(vtkIdType cell, std::vector<int>& vertices) const;

  MeshBlocks Blocks;
  size_t BlockBytes = 0;
  vtkTimeStamp BlocksTime;
  TurnedCells Turned;
  vtkTimeStamp SelectionTime;
  vtkTimeStamp TurnedTime;
  /// Only compared.
  const std::vector<int>* TurnedAmong = nullptr;
};

#endif
