/**
 * What becomes of one cell, decided from its ids and coordinates alone: left as it is, turned,
 * cut into tetrahedra, or dropped for want of a volume. Plan first, count, then write in place.
 *
 * A cell is inverted where the sum of its tetrahedra is negative, and folded where they have both
 * signs. The decision is per cell; neighbours agree because TetrahedralSplit does.
 */
#ifndef ConvexCellPlan_h
#define ConvexCellPlan_h

#include "TetrahedralSplit.h"

struct ConvexCellPlan
{
  enum FateType : unsigned char
  {
    Whole,      // goes out as the cell it is
    Tetrahedra, // goes out as its tetrahedra
    ZeroVolume, // nothing of it is left
    OtherType,  // not a shape that is handled here
    Ghost,      // the rest is refused before it gets here, by the owner of the mesh
    NonFinite,
    Imaginary, // sorts, but has nothing to draw
    Invalid
  };
  FateType Fate = Invalid;
  unsigned char Kept = 0;    // bit i: piece i of the split has a volume
  unsigned char Turned = 0;  // bit i: piece i is inside out
  unsigned char Dropped = 0; // pieces without a volume
  bool Inverted = false;
  bool Folded = false;
};

/** Where the next cell is written; advanced by WriteConvexCell. */
struct ConvexCellCursor
{
  vtkIdType Cell = 0;
  vtkIdType Id = 0;
};

/** The output arrays, each long enough: one entry per cell, Offsets one more. */
struct ConvexCellArrays
{
  unsigned char* Types;
  vtkIdType* Offsets;
  vtkIdType* Ids;
  vtkIdType* SourceCells;
};

/**
 * `ids`: merged point ids in VTK's order of the shape; `points`: their coordinates, all finite; may
 * be scaled here. Whole cells that repeat a point are cut into tetrahedra in either mode.
 */
ConvexCellPlan PlanConvexCell(
  TetrahedralSplit::Shape shape, const vtkIdType* ids, double (*points)[3], bool tetrahedraOnly);

/** Moves the cursor past what WriteConvexCell would write. */
void SkipConvexCell(
  const ConvexCellPlan& plan, TetrahedralSplit::Shape shape, ConvexCellCursor& cursor);

/** `ids` as planned; `outputIds`, by id, names them in the output (null: the same). */
void WriteConvexCell(const ConvexCellPlan& plan, TetrahedralSplit::Shape shape,
  const vtkIdType* ids, const vtkIdType* outputIds, vtkIdType sourceCell,
  const ConvexCellArrays& arrays, ConvexCellCursor& cursor);

#endif
