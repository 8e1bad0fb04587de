/**
 * What becomes of one cell, decided from its ids and coordinates alone: left as it is, turned,
 * cut into tetrahedra, or dropped for want of a volume. Plan first, count, then write in place.
 *
 * A cell is inverted where the sum of its tetrahedra is negative, and folded where they have both
 * signs from whichever corner it is seen. The decision is per cell; neighbours agree because
 * TetrahedralSplit does. Polyhedra: PolyhedronPlan.
 */
#ifndef ConvexCellPlan_h
#define ConvexCellPlan_h

#include "TetrahedralSplit.h"

#include <cstdint>

struct ConvexCellPlan
{
  enum FateType : unsigned char
  {
    Whole,      // goes out as the cell it is
    Tetrahedra, // goes out as its tetrahedra
    ZeroVolume, // nothing of it is left
    Open,       // a polyhedron whose faces do not close
    SeveralPieces,
    Concave,   // a polyhedron that no corner sees all of
    WrongList, // a polyhedron with a face list that does not fit
    OtherType, // not a shape that is handled here
    Ghost,     // the rest is refused before it gets here, by the owner of the mesh
    Hidden,    // blanked
    NonFinite,
    Imaginary, // sorts, but has nothing to draw
    Invalid
  };
  FateType Fate = Invalid;
  bool Inverted = false;
  bool Folded = false;
  bool NonConvex = false;   // and cut for that
  bool Uneven = false;      // pieces without a volume, or of both signs
  bool Thin = false;        // a piece so thin that a face's triangle may be flat
  bool ByFaces = false;     // cut along FaceTriangles, ConePlan
  bool Star = false;        // cut from a point within
  bool ButForFlat = false;  // cut from a corner that does not see what is flat: that is dropped
  bool Replaced = false;    // curved, or next to a curved cell, and cut for that
  int Apex = -1;            // the corner that the tetrahedra share, where it is not the usual one
  int Dropped = 0;          // pieces without a volume
  std::uint32_t Kept = 0;   // bit i: piece i of the split has a volume
  std::uint32_t Turned = 0; // bit i: piece i is inside out
};

/** Where the next cell is written; advanced by WriteConvexCell. */
struct ConvexCellCursor
{
  vtkIdType Cell = 0;
  vtkIdType Id = 0;
};

/** The output arrays, each long enough: one entry per cell, Offsets one more. The ids of a
 *  polyhedron are its face stream. */
struct ConvexCellArrays
{
  unsigned char* Types;
  vtkIdType* Offsets;
  vtkIdType* Ids;
  vtkIdType* SourceCells;
};

/** Which cells are cut. Those that repeat a point are, in any case. */
enum class ConvexCellCut
{
  None,      // those of a type that is convex by itself
  NonConvex, // those that ConvexityTest finds
  All
};

/** `ids`: merged point ids in VTK's order of the shape; `points`: their coordinates, all finite;
 * may be scaled here. */
ConvexCellPlan PlanConvexCell(
  TetrahedralSplit::Shape shape, const vtkIdType* ids, double (*points)[3], ConvexCellCut cut);

/** Moves the cursor past what WriteConvexCell would write. */
void SkipConvexCell(
  const ConvexCellPlan& plan, TetrahedralSplit::Shape shape, ConvexCellCursor& cursor);

/** `ids` as planned; `outputIds`, by id, names them in the output (null: the same). */
void WriteConvexCell(const ConvexCellPlan& plan, TetrahedralSplit::Shape shape,
  const vtkIdType* ids, const vtkIdType* outputIds, vtkIdType sourceCell,
  const ConvexCellArrays& arrays, ConvexCellCursor& cursor);

/** Begins a cell in the arrays; its ids are to follow. */
void BeginConvexCell(
  int type, vtkIdType sourceCell, const ConvexCellArrays& arrays, ConvexCellCursor& cursor);

#endif
