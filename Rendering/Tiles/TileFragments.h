/**
 * Pieces of rays in cells, waiting to be shaded: coverage appends what it finds, shading takes
 * full vectors of any cells.
 */
#ifndef TileFragments_h
#define TileFragments_h

#include "TileCells.h"

#include <algorithm>
#include <cstdint>

struct TileFragments
{
  /** Emptied between cells when there are this many; one cell covers a tile at most, or is handed on between its
   * rows. A long queue goes from loop to loop less often, a short one tells sooner what is hidden. */
  static constexpr int Shortest = 512;
  static constexpr int Longest = 2048;
  int Full = Shortest;
  static constexpr int Capacity = Longest + TileSize::Pixels * TileSize::MostRows + 64;

  int Count = 0;
  /** u where the ray enters, u lost until it leaves; scalar times weight at both. */
  alignas(64) float Entry[Capacity];
  alignas(64) float Extent[Capacity];
  alignas(64) float ScalarIn[Capacity];
  alignas(64) float ScalarOut[Capacity];
  /** In the tile, row by row. */
  alignas(64) int Pixel[Capacity];
  /** The same of cells whose fragments are not complete yet. */
  alignas(64) std::uint16_t RowPixel[Capacity];
  /** Where they are named (NamesCells): the cell's id. */
  alignas(64) int Cell[Capacity];
  /** Shaded: premultiplied red, green, blue, and minus alpha, in slots (TileColors-inl.h). */
  alignas(64) float Slots[Capacity][4];

  /** The fragments from here on are this cell's. */
  void BeginCell(int cell)
  {
    if (this->NamesCells)
    {
      // A cell that covered nothing is forgotten.
      const bool isNew = this->Runs == 0 || this->RunStart[this->Runs - 1] < this->Count;
      this->Runs += isNew ? 1 : 0;
      this->RunStart[this->Runs - 1] = this->Count;
      this->RunCell[this->Runs - 1] = cell;
    }
  }
  void NameCells()
  {
    for (int run = 0; run < this->Runs; ++run)
    {
      const int end = run + 1 < this->Runs ? this->RunStart[run + 1] : this->Count;
      // Whole vectors: what runs over is the next cell's, or padding.
      for (int at = this->RunStart[run]; at < end; at += Vector)
      {
        std::fill_n(this->Cell + at, Vector, this->RunCell[run]);
      }
    }
    this->Runs = 0;
  }
  bool NamesCells = false;

  /** The lanes that are looked at: of the blocks that cover a box, or of the vectors of a row. */
  void CountLanes(int width, int height, int blockWidth, int blockHeight)
  {
    if (this->CountsLanes && width > 0 && height > 0)
    {
      const int blocks = ((width + blockWidth - 1) / blockWidth) * ((height + blockHeight - 1) / blockHeight);
      this->LanesOfBlocks += static_cast<long long>(blocks) * blockWidth * blockHeight;
    }
  }
  bool CountsLanes = false;
  long long LanesOfBlocks = 0;

  /** Repeats the last fragment until a vector is full. */
  void FillLastVector()
  {
    for (float* values : { this->Entry, this->Extent, this->ScalarIn, this->ScalarOut })
    {
      std::fill_n(values + this->Count, Vector, values[std::max(this->Count - 1, 0)]);
    }
    std::fill_n(this->Pixel + this->Count, Vector, this->Pixel[std::max(this->Count - 1, 0)]);
  }

private:
  static constexpr int Vector = 16;
  int Runs = 0;
  int RunStart[Capacity];
  int RunCell[Capacity];
};

/** What was shaded: pieces, and the lanes of their vectors. */
struct TileShadeCount
{
  long long Pieces = 0;
  long long Lanes = 0;
};

/** What is left to shade of fragments that a node of the transfer function, or an optical depth of
 * 1, cuts: a part or all. */
struct TileRemainders
{
  int Count = 0;
  alignas(64) float First[TileFragments::Capacity];
  alignas(64) float Last[TileFragments::Capacity];
  alignas(64) float Length[TileFragments::Capacity];
  /** The light that comes through what is shaded already. */
  alignas(64) float Through[TileFragments::Capacity];
  alignas(64) int Piece[TileFragments::Capacity];
  alignas(64) int Fragment[TileFragments::Capacity];
};

#endif
