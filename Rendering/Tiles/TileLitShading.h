/**
 * Colour and opacity of fragments with light, gradient opacity or other components than the
 * opacity's: what TileShading-inl.h does for those without.
 *
 * A fragment is cut where the transfer function bends, where the optical depth of a piece would
 * pass 1, where the gradient has turned too far or a light passes from one side of it to the other.
 * In a piece colour and light are smooth: Gauss nodes. Not guaranteed: more than 256 such cuts in a
 * fragment, and the edge of a light's cone within a cell.
 */
#ifndef TileLitShading_h
#define TileLitShading_h

struct TileFragments;
struct TileLitPieces;
struct TileRectangle;
struct TileShadeCount;
struct TileTask;

namespace TileLitShading
{
/** Fills the colours; `task` has Lighting and the fields. */
TileShadeCount Shade(const TileTask& task, const TileRectangle& tile, TileFragments& fragments,
  TileLitPieces (&remainders)[2]);
}

#endif
