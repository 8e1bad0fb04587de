#ifndef SeedRuns_h
#define SeedRuns_h

#include <functional>

/// Random meshes by their seeds.
namespace SeedRuns
{
/// Asks of `count` seeds from `first` on whether they fail; prints and returns how many do. Stops at
/// ten failures alone: how long it may take is for ctest to say.
int CountFailures(
  unsigned int first, unsigned int count, const std::function<bool(unsigned int)>& fails);
}

#endif
