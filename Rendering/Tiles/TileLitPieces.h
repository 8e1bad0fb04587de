/**
 * What is left to shade of fragments with light, gradient opacity or other components: as
 * TileRemainders, and what changes along the way. `Rise`: until the fragment ends.
 */
#ifndef TileLitPieces_h
#define TileLitPieces_h

#include "TileFragments.h"

struct TileLitPieces
{
  int Count = 0;
  alignas(64) float First[TileFragments::Capacity];
  alignas(64) float Last[TileFragments::Capacity];
  alignas(64) float Length[TileFragments::Capacity];
  alignas(64) float Through[TileFragments::Capacity];
  /** Depth less that of u = 0. */
  alignas(64) float Depth[TileFragments::Capacity];
  alignas(64) float DepthRise[TileFragments::Capacity];
  alignas(64) float Gradient[3][TileFragments::Capacity];
  alignas(64) float GradientRise[3][TileFragments::Capacity];
  alignas(64) float Color[3][TileFragments::Capacity];
  alignas(64) float ColorRise[3][TileFragments::Capacity];
  alignas(64) int Piece[TileFragments::Capacity];
  alignas(64) int Fragment[TileFragments::Capacity];
  alignas(64) int Pixel[TileFragments::Capacity];
};

struct TileLitRemainders
{
  TileLitPieces Pieces[2];
};

#endif
