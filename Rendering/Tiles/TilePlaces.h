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
    this->At(cell) = place;
  }

  /** Finds as long as nothing is set: in pointers of its own, which need not be read again after
   *  every store of a byte. */
  class Finder
  {
  public:
    explicit Finder(const TilePlaces& places)
      : Slots(places.Slots.data())
      , Owners(places.Owners.data())
      , Places(places.Places.data())
      , Count(places.Owners.size())
    {
    }
    int Find(int cell) const
    {
      const int cluster = cell >> TileClusters::Shift;
      const auto slot = static_cast<std::size_t>(this->Slots[cluster]);
      return slot < this->Count && this->Owners[slot] == cluster
        ? this->Places[(slot << TileClusters::Shift) + (cell & (TileClusters::Size - 1))]
        : None;
    }

  private:
    const int* Slots;
    const int* Owners;
    const int* Places;
    std::size_t Count;
  };

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
  int& At(int cell)
  {
    const auto slot = static_cast<std::size_t>(this->Slots[cell >> TileClusters::Shift]);
    return this->Places[(slot << TileClusters::Shift) + (cell & (TileClusters::Size - 1))];
  }

  // Of a cluster: its slot; true only where the slot's owner says so too.
  std::vector<int> Slots;
  std::vector<int> Owners;
  std::vector<int> Places;
};

#endif
