#include "TileLoop.h"

#include "TileScratchPool.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <memory>
#include <thread>
#include <utility>

namespace
{
/// One loop's question, asked by the thread that made it, and its answer for all.
class AbortAnswer
{
public:
  explicit AbortAnswer(const TileLoop::AbortCheck& check)
    : Check(check)
    , Caller(std::this_thread::get_id())
  {
  }
  bool IsAborted()
  {
    if (!this->Answer && this->Check && std::this_thread::get_id() == this->Caller && this->Check())
    {
      this->Answer = true;
    }
    return this->Answer;
  }
  bool IsGiven() const { return this->Answer; }

private:
  const TileLoop::AbortCheck& Check;
  const std::thread::id Caller;
  std::atomic<bool> Answer{ false };
};
}

//------------------------------------------------------------------------------
bool TileLoop::Run(const std::vector<int>& tiles, int row, const AbortCheck& isAborted,
  TileScratchPool& pool, const Drawer& draw)
{
  AbortAnswer answer(isAborted);
  const int count = static_cast<int>(tiles.size());
  const bool callerWaits = std::strcmp(vtkSMPTools::GetBackend(), "STDThread") == 0;
  const int share = isAborted && callerWaits ? row : count;
  // Other threads may take all tiles before the caller comes to its first.
  if (answer.IsAborted())
  {
    return false;
  }
  for (int first = 0; first < count; first += share)
  {
    const int end = std::min(first + share, count);
    std::atomic<int> next{ first };
    vtkSMPTools::For(0, std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()), 1,
      [&](vtkIdType, vtkIdType)
      {
        std::unique_ptr<TileScratch> scratch = pool.Take();
        for (int i = next++; i < end && !answer.IsAborted(); i = next++)
        {
          draw(tiles[i], *scratch);
        }
        pool.Return(std::move(scratch));
      });
    if (answer.IsGiven() || (end < count && answer.IsAborted()))
    {
      return false;
    }
  }
  return true;
}
