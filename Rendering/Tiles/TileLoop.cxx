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
bool TileLoop::Run(int tilesX, int tilesY, const AbortCheck& isAborted, TileScratchPool& pool,
  const Drawer& draw)
{
  AbortAnswer answer(isAborted);
  const int tiles = tilesX * tilesY;
  const bool callerWaits = std::strcmp(vtkSMPTools::GetBackend(), "STDThread") == 0;
  const int share = isAborted && callerWaits ? tilesX : tiles;
  for (int first = 0; first < tiles; first += share)
  {
    vtkSMPTools::For(first, std::min(first + share, tiles), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::unique_ptr<TileScratch> scratch = pool.Take();
        for (auto tile = static_cast<int>(begin); tile < end && !answer.IsAborted(); ++tile)
        {
          draw(tile, *scratch);
        }
        pool.Return(std::move(scratch));
      });
    if (answer.IsGiven() || (first + share < tiles && answer.IsAborted()))
    {
      return false;
    }
  }
  return true;
}
