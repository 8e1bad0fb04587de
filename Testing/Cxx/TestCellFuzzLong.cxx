// 800 random cells of each type, 20,000 in all, degenerate on purpose. Arguments: the first seed, and
// how many of each; 1 and 10000 take some minutes.

#include "CellFuzz.h"
#include "TestScene.h"

#include <cstdlib>

int TestCellFuzzLong(int argc, char* argv[])
{
  TestChecks checks;
  const bool given = argc > 2 && argv[1][0] != '-';
  const auto first = static_cast<unsigned int>(given ? std::atoi(argv[1]) : 1);
  const auto count = static_cast<unsigned int>(given ? std::atoi(argv[2]) : 800);
  CHECK(CellFuzz::CountFailures(first, count) == 0);
  return checks.Result();
}
