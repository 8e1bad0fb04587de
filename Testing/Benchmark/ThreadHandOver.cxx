#include "ThreadHandOver.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <thread>

namespace
{
constexpr int Rounds = 10;
constexpr int Turns = 2000;

// Waits for its own numbers and answers with the next.
void Answer(std::atomic<int>& word, int first, int turns)
{
  for (int turn = 0; turn < turns; ++turn)
  {
    while (word.load(std::memory_order_acquire) != first + 2 * turn)
    {
    }
    word.store(first + 2 * turn + 1, std::memory_order_release);
  }
}
}

//------------------------------------------------------------------------------
double ThreadHandOver::Measure()
{
  if (std::thread::hardware_concurrency() < 2)
  {
    return 0.0;
  }
  double best = std::numeric_limits<double>::max();
  for (int round = 0; round < Rounds; ++round)
  {
    std::atomic<int> word{ 0 };
    std::thread other(Answer, std::ref(word), 1, Turns);
    const auto start = std::chrono::steady_clock::now();
    Answer(word, 0, Turns);
    const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
    other.join();
    best = std::min(best, elapsed.count() / (2 * Turns));
  }
  return best;
}

//------------------------------------------------------------------------------
void ThreadHandOver::Print()
{
  std::printf("\nFrom one thread to another: %.0f ns\n", Measure());
}
