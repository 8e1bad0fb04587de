/**
 * Cells split in two equal halves across the line of sight.
 *
 * Thirteen directions stand for all: the axes, the diagonals of the faces of a cube, and its own.
 * The one nearest to the line of sight splits the cells by the median of their centres along it, so
 * that what is behind a cell of the far half is seldom in the near one. A direction is split when it
 * is first asked for, and kept: one byte per cell.
 */
#ifndef SightHalves_h
#define SightHalves_h

#include "SignedLinks.h"

#include <array>
#include <vector>

class SightHalves
{
public:
  static constexpr int NumberOfDirections = 13;
  /** In the byte of a cell: it is on the positive side of the median. Bit k, of the first four:
   *  its link k leads to a cell of the same half. */
  static constexpr unsigned char Positive = 16;

  /** Both must stay as they are. `centers`: three per cell. */
  void Build(const SignedLinks& links, const std::vector<double>& centers);

  /** A byte per cell, for the direction nearest to `towards`. `farSide`: what a byte has of
   *  Positive where the cell is in the half away from where `towards` points. */
  const unsigned char* Find(const double towards[3], unsigned char& farSide);

private:
  std::vector<unsigned char> Split(const double direction[3]) const;
  void MarkOwnLinks(std::vector<unsigned char>& halves) const;

  const SignedLinks* Links = nullptr;
  const std::vector<double>* Centers = nullptr;
  std::array<std::vector<unsigned char>, NumberOfDirections> Halves;
};

#endif
