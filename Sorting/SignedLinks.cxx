#include "SignedLinks.h"

#include <algorithm>
#include <numeric>

//------------------------------------------------------------------------------
void SignedLinks::Build(const std::vector<CellComplex::Contact>& contacts, int numberOfCells)
{
  this->Offsets.assign(static_cast<size_t>(numberOfCells) + 1, 0);
  for (const CellComplex::Contact& contact : contacts)
  {
    ++this->Offsets[contact.Cells[0] + 1];
    ++this->Offsets[contact.Cells[1] + 1];
  }
  std::transform(this->Offsets.begin() + 1, this->Offsets.end(), this->Offsets.begin() + 1,
    [](int count) { return std::max(count, FewLinks); });
  std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
  this->Neighbors.resize(static_cast<size_t>(this->Offsets.back()));
  this->ContactsAndSides.assign(this->Neighbors.size(), 2 * static_cast<int>(contacts.size()));
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    std::fill_n(&this->Neighbors[this->Begin(cell)], this->End(cell) - this->Begin(cell), cell);
  }
  std::vector<int> next = this->Offsets;
  for (int i = 0; i < static_cast<int>(contacts.size()); ++i)
  {
    for (int side = 0; side < 2; ++side)
    {
      const int cell = contacts[i].Cells[side];
      const int link = next[cell]++;
      this->Neighbors[link] = contacts[i].Cells[1 - side];
      this->ContactsAndSides[link] = 2 * i + side;
    }
  }
}
