/**
 * Which cells touch, cell by cell, and which of two is nearer to the eye.
 */
#ifndef SignedLinks_h
#define SignedLinks_h

#include "CellComplex.h"
#include "ContactSigns.h"

#include <vector>

class SignedLinks
{
public:
  /** No cell has fewer: a link that it lacks leads to the cell itself, and neither hides the other.
   *  So the links of a tetrahedron, on the boundary too, need not be counted. */
  static constexpr int FewLinks = 4;

  /** `contacts` by the numbers of cells below `numberOfCells`. */
  void Build(const std::vector<CellComplex::Contact>& contacts, int numberOfCells);

  int GetNumberOfCells() const { return static_cast<int>(this->Offsets.size()) - 1; }
  int GetNumberOfLinks() const { return static_cast<int>(this->Neighbors.size()); }
  /** The links of a cell: from Begin on, up to End. */
  int Begin(int cell) const { return this->Offsets[cell]; }
  int End(int cell) const { return this->Offsets[cell + 1]; }
  int GetNeighbor(int link) const { return this->Neighbors[link]; }
  /** Of a link to another cell. */
  int GetContact(int link) const { return this->ContactsAndSides[link] >> 1; }

  /** 1 where the cell across a link is nearer to the eye, -1 where it is farther, 0 where neither
   *  hides the other; the other way round where `reversed` is 1, not 0. */
  int CompareAcross(int link, int reversed = 0) const
  {
    const int contactAndSide = this->ContactsAndSides[link];
    const int sign = this->Signs[contactAndSide >> 1];
    // All bits of `mask` where the sign is to be negated: no branch, no product.
    const int mask = ((contactAndSide & 1) - 1) ^ -reversed;
    return (sign ^ mask) - mask;
  }

  /** Of the contacts, for the eye. */
  ContactSigns Signs;

private:
  std::vector<int> Offsets{ 0 };
  // Per link: the cell across it; the contact, with the cell's own side in the last bit.
  std::vector<int> Neighbors;
  std::vector<int> ContactsAndSides;
};

#endif
