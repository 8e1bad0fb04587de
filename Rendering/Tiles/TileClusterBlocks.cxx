#include "TileClusterBlocks.h"

#include <algorithm>

//------------------------------------------------------------------------------
void TileClusterBlocks::Build(
  const std::vector<int>& ids, const std::vector<std::size_t>& begins, std::size_t count)
{
  this->Seen.assign((count >> Shift) + 1, 0);
  std::vector<int> lastUse(this->Seen.size(), -1);
  this->Blocks.clear();
  this->BlocksBegin.assign(1, 0);
  for (std::size_t cluster = 0; cluster + 1 < begins.size(); ++cluster)
  {
    for (std::size_t at = begins[cluster]; at < begins[cluster + 1]; ++at)
    {
      const int block = ids[at] >> Shift;
      if (lastUse[block] != static_cast<int>(cluster))
      {
        lastUse[block] = static_cast<int>(cluster);
        this->Blocks.push_back(block);
      }
    }
    this->BlocksBegin.push_back(static_cast<int>(this->Blocks.size()));
  }
  this->Blocks.shrink_to_fit();
}

//------------------------------------------------------------------------------
void TileClusterBlocks::MarkSeen(const std::vector<unsigned char>& clusters)
{
  std::fill(this->Seen.begin(), this->Seen.end(), static_cast<unsigned char>(0));
  for (std::size_t cluster = 0; cluster + 1 < this->BlocksBegin.size(); ++cluster)
  {
    if (clusters[cluster])
    {
      for (int at = this->BlocksBegin[cluster]; at < this->BlocksBegin[cluster + 1]; ++at)
      {
        this->Seen[this->Blocks[at]] = 1;
      }
    }
  }
}

//------------------------------------------------------------------------------
std::size_t TileClusterBlocks::GetMemorySize() const
{
  return 4 * (this->BlocksBegin.size() + this->Blocks.size()) + this->Seen.size();
}
