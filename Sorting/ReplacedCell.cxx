#include "ReplacedCell.h"

#include "ConvexCellPoints.h"
#include "CurvedCells.h"

#include "vtkCellType.h"

namespace
{
double SixVolumes(const ConvexCellPoints& points, const vtkIdType* ids)
{
  double x[4][3];
  points.Get(ids, 4, x);
  return TetrahedralSplit::SixVolumes(x[0], x[1], x[2], x[3]);
}
}

ConvexCellPlan ReplacedCell::Plan(const CurvedCells& curved, const ConvexCellPoints& points,
  vtkIdType cell, ConvexCellCursor& cursor)
{
  ConvexCellPlan plan;
  vtkIdType turned = 0, kept = 0;
  double sum = 0.0;
  curved.VisitPieces(cell,
    [&](const vtkIdType* ids)
    {
      const double volume = SixVolumes(points, ids);
      kept += volume != 0.0;
      turned += volume < 0.0;
      plan.Dropped += volume == 0.0;
      sum += volume;
    });
  cursor.Cell += kept;
  cursor.Id += 4 * kept;
  plan.Fate = kept > 0 ? ConvexCellPlan::Tetrahedra : ConvexCellPlan::ZeroVolume;
  plan.Replaced = true;
  plan.Inverted = sum < 0.0;
  plan.Folded = turned > 0 && turned < kept;
  return plan;
}

void ReplacedCell::Write(const CurvedCells& curved, const ConvexCellPoints& points,
  vtkIdType cell, const ConvexCellArrays& arrays, ConvexCellCursor& cursor)
{
  const vtkIdType* outputIds = points.GetOutputIds();
  curved.VisitPieces(cell,
    [&](const vtkIdType* ids)
    {
      const double volume = SixVolumes(points, ids);
      if (volume != 0.0)
      {
        const int second = volume < 0.0 ? 2 : 1;
        BeginConvexCell(VTK_TETRA, cell, arrays, cursor);
        for (const int corner : { 0, second, 3 - second, 3 })
        {
          arrays.Ids[cursor.Id++] = outputIds ? outputIds[ids[corner]] : ids[corner];
        }
      }
    });
}
