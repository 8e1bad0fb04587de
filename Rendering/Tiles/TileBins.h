/**
 * Which cells touch which tile, in a given order or that of the mesh: a counting sort in shares
 * whose number does not depend on the number of threads, and so neither does the result.
 */
#ifndef TileBins_h
#define TileBins_h

#include <cstddef>
#include <cstdint>
#include <vector>

class TileClusters;

class TileBins
{
public:
  /** `boxes` of class TileCells; `order`: ids of cells, null for 0, 1, 2 and so on; `clusters`: those
   *  of them that are seen, null for all. */
  void Fill(const std::vector<std::uint32_t>& boxes, const std::vector<int>* order,
    const TileClusters* clusters, int tilesX, int tilesY);

  int GetNumberOfTiles() const { return static_cast<int>(this->Begin.size()) - 1; }
  /** A cell counts once in each of its tiles. */
  long long GetNumberOfEntries() const { return static_cast<long long>(this->Begin.back()); }
  std::size_t GetMemorySize() const
  {
    return this->Cells.capacity() * sizeof(int) +
           (this->Begin.capacity() + this->Places.capacity()) * sizeof(std::size_t);
  }
  int* GetTile(int tile) { return this->Cells.data() + this->Begin[tile]; }
  int GetSize(int tile) const
  {
    return static_cast<int>(this->Begin[tile + 1] - this->Begin[tile]);
  }
  /** All tiles, those with the most cells first: threads that take them in this order end together. */
  const std::vector<int>& GetHeaviestFirst() const { return this->HeaviestFirst; }

private:
  template <class Visit>
  void VisitShare(const std::vector<std::uint32_t>& boxes, const std::vector<int>* order,
    const TileClusters* clusters, int share, Visit&& visit) const;
  void Accumulate(int tiles);

  std::vector<int> Cells;
  std::vector<std::size_t> Begin{ 0 };
  /** Per share and tile: first how many cells, then where the next one goes. */
  std::vector<std::size_t> Places;
  std::vector<int> HeaviestFirst;
  int TilesX = 0;
};

#endif
