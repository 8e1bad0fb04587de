/**
 * Where the cells of one tile are in its list: a table of the clusters that they belong to (class
 * TileClusters), so that it needs the memory of those alone, and a
 * number for each cluster of the mesh.
 */
#ifndef TilePlaces_h
#define TilePlaces_h

#include "TileClusters.h"

#include <cstddef>
#include <vector>

class TilePlaces
{
public:
  /** For a mesh of so many cells; nothing has a place. */
  void Clear(std::size_t cells)
  {
    this->Slots.resize((cells >> TileClusters::Shift) + 1);
    this->Owners.clear();
    this->Places.clear();
  }

  void Set(int cell, int place)
  {
    const int cluster = cell >> TileClusters::Shift;
    if (!this->HasSlot(cluster))
    {
      this->Slots[cluster] = static_cast<int>(this->Owners.size());
      this->Owners.push_back(cluster);
      this->Places.resize(this->Places.size() + TileClusters::Size, None);
    }
    this->Places[this->Index(cell)] = place;
  }

  int Find(int cell) const
  {
    return this->HasSlot(cell >> TileClusters::Shift) ? this->Places[this->Index(cell)] : None;
  }

  std::size_t GetMemorySize() const
  {
    return sizeof(int) *
      (this->Slots.capacity() + this->Owners.capacity() + this->Places.capacity());
  }

  static constexpr int None = -1;

private:
  bool HasSlot(int cluster) const
  {
    const auto slot = static_cast<std::size_t>(this->Slots[cluster]);
    return slot < this->Owners.size() && this->Owners[slot] == cluster;
  }
  std::size_t Index(int cell) const
  {
    const auto slot = static_cast<std::size_t>(this->Slots[cell >> TileClusters::Shift]);
    return (slot << TileClusters::Shift) + (cell & (TileClusters::Size - 1));
  }

  // Of a cluster: its slot; true only where the slot's owner says so too.
  std::vector<int> Slots;
  std::vector<int> Owners;
  std::vector<int> Places;
};

#endif
