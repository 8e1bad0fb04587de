// 10,000 random cells of every type, degenerate on purpose. Arguments: the first seed, how many.

#include "CellFuzz.h"
#include "TestScene.h"

#include <cstdlib>

int TestCellFuzzLong(int argc, char* argv[])
{
  TestChecks checks;
  const bool given = argc > 2 && argv[1][0] != '-';
  const auto first = static_cast<unsigned int>(given ? std::atoi(argv[1]) : 1);
  const auto count = static_cast<unsigned int>(given ? std::atoi(argv[2]) : 10000);
  CHECK(CellFuzz::CountFailures(first, count, 900.0) == 0);
  return checks.Result();
}
