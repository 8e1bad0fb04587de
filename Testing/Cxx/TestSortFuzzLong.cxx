// 10,000 random small meshes with holes, by convexified MPVO. Arguments: the first seed, how many.

#include "SortFuzz.h"
#include "TestScene.h"

#include <cstdlib>

int TestSortFuzzLong(int argc, char* argv[])
{
  TestChecks checks;
  const bool given = argc > 2 && argv[1][0] != '-';
  const auto first = static_cast<unsigned int>(given ? std::atoi(argv[1]) : 1);
  const auto count = static_cast<unsigned int>(given ? std::atoi(argv[2]) : 10000);
  CHECK(SortFuzz::CountFailures(first, count) == 0);
  return checks.Result();
}
