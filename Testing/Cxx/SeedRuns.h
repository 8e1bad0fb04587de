#ifndef SeedRuns_h
#define SeedRuns_h

#include <functional>

/// Random meshes by their seeds.
namespace SeedRuns
{
/// Asks of `count` seeds from `first` on whether they fail; prints and returns how many do. Stops
/// after `seconds`, and at ten failures.
int CountFailures(unsigned int first, unsigned int count, double seconds,
  const std::function<bool(unsigned int)>& fails);
}

#endif
