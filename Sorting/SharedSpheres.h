/**
 * Cells that share a sphere up to rounding, as the tetrahedra of a box do.
 *
 * They have one key for every eye, so that they may be sorted as one. A cell is compared with the
 * few before it: cells of one sphere are those of one hexahedron, or of its half, and come soon
 * after each other. Not guaranteed: that cells far apart in the numbering are found.
 */
#ifndef SharedSpheres_h
#define SharedSpheres_h

#include "PowerLift.h"

#include "vtkType.h"

#include <hwy/cache_control.h>

#include <cstdint>
#include <vector>

class SharedSpheres
{
public:
  /** Gives the cells of one sphere the lift of its first. Keeps nothing where so few cells share
   *  one that sorting each by itself is faster: IsEmpty is true then. */
  void Build(std::vector<PowerLift>& lifts);
  void Clear();

  bool IsEmpty() const { return this->Lifts.empty(); }
  const std::vector<PowerLift>& GetLifts() const { return this->Lifts; }

  vtkIdType CountCells(std::uint32_t sphere) const
  {
    return this->Begins[sphere + 1] - this->Begins[sphere];
  }

  /** Asks the memory for where a sphere's cells begin, or, that at hand, for the cells. */
  void FetchBegin(std::uint32_t sphere) const { hwy::Prefetch(&this->Begins[sphere]); }
  void FetchCells(std::uint32_t sphere) const
  {
    hwy::Prefetch(this->Cells.data() + this->Begins[sphere]);
  }

  /** Writes the ids of a sphere's cells, smallest first; returns where the next one goes. */
  vtkIdType* WriteCells(std::uint32_t sphere, vtkIdType* to) const
  {
    for (std::uint32_t i = this->Begins[sphere]; i < this->Begins[sphere + 1]; ++i)
    {
      *to++ = this->Cells[i];
    }
    return to;
  }

private:
  std::vector<std::uint32_t> FindSpheres(std::vector<PowerLift>& lifts);

  std::vector<PowerLift> Lifts;
  /** Cells by sphere, and where those of each begin, and the end. */
  std::vector<std::uint32_t> Cells;
  std::vector<std::uint32_t> Begins;
};

#endif
