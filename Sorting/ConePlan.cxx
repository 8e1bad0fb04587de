#include "ConePlan.h"

#include "vtkCellType.h"

namespace
{
double SixVolumes(const double (*points)[3], double sign, int apex, int a, int b, int c)
{
  return sign * TetrahedralSplit::SixVolumes(points[apex], points[a], points[b], points[c]);
}
}

bool ConePlan::Make(const FaceTriangles& triangles, const double (*points)[3], double sign,
  ConvexCellPlan& plan, ConvexCellCursor& cursor, double flatness)
{
  const int apex = triangles.FindApex(sign, flatness);
  if (apex < 0)
  {
    return false;
  }
  plan.Fate = ConvexCellPlan::Tetrahedra;
  plan.Apex = apex;
  plan.ByFaces = true;
  plan.Folded = false;
  plan.ButForFlat = false;
  plan.Dropped = 0;
  triangles.VisitCone(apex,
    [&](int a, int b, int c)
    {
      const double volume = SixVolumes(points, sign, apex, a, b, c);
      const bool hasVolume = volume > 0.0;
      plan.ButForFlat = plan.ButForFlat || volume < 0.0;
      plan.Dropped += !hasVolume;
      cursor.Cell += hasVolume;
      cursor.Id += hasVolume ? 4 : 0;
    });
  return true;
}

void ConePlan::Write(const ConvexCellPlan& plan, const FaceTriangles& triangles,
  const double (*points)[3], double sign, const vtkIdType* named, vtkIdType sourceCell,
  const ConvexCellArrays& arrays, ConvexCellCursor& cursor)
{
  triangles.VisitCone(plan.Apex,
    [&](int a, int b, int c)
    {
      if (SixVolumes(points, sign, plan.Apex, a, b, c) > 0.0)
      {
        BeginConvexCell(VTK_TETRA, sourceCell, arrays, cursor);
        for (const int vertex : { plan.Apex, a, sign < 0.0 ? c : b, sign < 0.0 ? b : c })
        {
          arrays.Ids[cursor.Id++] = named[vertex];
        }
      }
    });
}
