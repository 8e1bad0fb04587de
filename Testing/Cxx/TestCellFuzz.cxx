// Random cells of every type, degenerate on purpose: a few of those of TestCellFuzzLong.

#include "CellFuzz.h"
#include "TestScene.h"

int TestCellFuzz(int, char*[])
{
  TestChecks checks;
  CHECK(CellFuzz::CountFailures(1, 150) == 0);
  return checks.Result();
}
