#include "SignedLinks.h"

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
  std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
  std::vector<int> next = this->Offsets;
  this->Links.resize(2 * contacts.size());
  for (int i = 0; i < static_cast<int>(contacts.size()); ++i)
  {
    for (int side = 0; side < 2; ++side)
    {
      const int cell = contacts[i].Cells[side];
      this->Links[next[cell]++] = { contacts[i].Cells[1 - side], 2 * i + side };
    }
  }
}
