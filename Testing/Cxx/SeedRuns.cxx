#include "SeedRuns.h"

#include <chrono>
#include <iostream>

//------------------------------------------------------------------------------
int SeedRuns::CountFailures(
  unsigned int first, unsigned int count, const std::function<bool(unsigned int)>& fails)
{
  const auto begin = std::chrono::steady_clock::now();
  auto elapsed = [&]
  { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  int failures = 0;
  unsigned int seed = first;
  for (; seed < first + count && failures < 10; ++seed)
  {
    failures += fails(seed) ? 1 : 0;
  }
  std::cout << seed - first << " of " << count << " meshes in " << elapsed() << " s, " << failures
            << " failed\n";
  return failures;
}
