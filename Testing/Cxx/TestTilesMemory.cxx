// The memory of the Tiles engine. Operators new are counted in this executable alone: after frames that
// have seen all there is, none allocates; per tetrahedron at most 96 bytes last and at most 64 more
// serve a frame, also where one tile has all of them. Cells are to share their points, and their order
// to be right: each that shares none lasts with 120 bytes, and pieces to be sorted take 32 each.

#include "TileArrays.h"

#include "vtkSMPTools.h"

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <new>

namespace
{
std::atomic<long long> Allocations{ 0 };
}

void* operator new(std::size_t size)
{
  ++Allocations;
  void* memory = std::malloc(size > 0 ? size : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace
{
constexpr int Frames = 6;

void DrawRound(TileArrays& arrays)
{
  for (int frame = 0; frame < Frames; ++frame)
  {
    const double angle = 0.7 + 0.9 * frame;
    arrays.LookFrom({ 5.0 * std::cos(angle), 5.0 * std::sin(angle), 1.5 }, 30.0, 300, 280);
    arrays.Render();
  }
}

bool Passes(bool good, const char* text, double found)
{
  std::cout << text << ": " << found << (good ? "\n" : ", FAILED\n");
  return good;
}

bool CheckArrays(TileArrays& arrays, bool spiky, const char* name)
{
  arrays.SetFunction(spiky);
  arrays.SetMesh();
  DrawRound(arrays);
  // Lists that a tile asks for the first time may be another tile's next time.
  DrawRound(arrays);
  const long long before = Allocations;
  DrawRound(arrays);
  const double cells = arrays.GetNumberOfCells();
  std::cout << name << ", " << cells << " tetrahedra\n";
  const double last = static_cast<double>(arrays.Engine.GetMeshMemory()) / cells;
  const double frame = static_cast<double>(arrays.Engine.GetFrameMemory()) / cells;
  const bool first = Passes(Allocations == before, "allocations of six more frames",
    static_cast<double>(Allocations - before));
  const bool second = Passes(last <= 96.0, "lasting bytes per tetrahedron", last);
  return Passes(frame <= 64.0, "bytes of a frame per tetrahedron", frame) && first && second;
}
}

int main()
{
  // Others allocate what they run threads with.
  vtkSMPTools::SetBackend("Sequential");
  bool good = true;
  for (const bool spiky : { false, true })
  {
    TileArrays lattice(30);
    good = CheckArrays(lattice, spiky, spiky ? "lattice, spiky" : "lattice") && good;
  }
  // One tile has all cells.
  TileArrays far(30);
  for (float& x : far.Points)
  {
    x *= 0.15f;
  }
  good = CheckArrays(far, false, "lattice in one tile") && good;
  return good ? 0 : 1;
}
