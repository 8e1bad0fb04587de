#include "BenchmarkThreads.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>

namespace
{
// Asleep, so that others come to their turn on a machine with work of its own, too.
constexpr std::chrono::milliseconds Nap(1);
constexpr int NapsPerThread = 16;
// A thread that had no turn in so many loops takes no part.
constexpr int Loops = 10;

int CountInOneLoop(int naps)
{
  std::mutex mutex;
  std::set<std::thread::id> found;
  vtkSMPTools::For(0, naps, 1,
    [&](vtkIdType, vtkIdType)
    {
      {
        const std::lock_guard<std::mutex> lock(mutex);
        found.insert(std::this_thread::get_id());
      }
      std::this_thread::sleep_for(Nap);
    });
  return static_cast<int>(found.size());
}
}

//------------------------------------------------------------------------------
int BenchmarkThreads::Count()
{
  const int expected = vtkSMPTools::GetEstimatedNumberOfThreads();
  const int naps =
    NapsPerThread * std::max({ 1, expected, static_cast<int>(std::thread::hardware_concurrency()) });
  int most = 0;
  for (int loop = 0; loop < Loops && most < expected; ++loop)
  {
    most = std::max(most, CountInOneLoop(naps));
  }
  return most;
}

//------------------------------------------------------------------------------
void BenchmarkThreads::Set(int threads)
{
  if (vtkSMPTools::GetEstimatedNumberOfThreads() != threads)
  {
    vtkSMPTools::Initialize(threads);
  }
}

//------------------------------------------------------------------------------
bool BenchmarkThreads::Use(int threads)
{
  Set(threads);
  // The tiles' loop has as many turns as the estimate says.
  return vtkSMPTools::GetEstimatedNumberOfThreads() == threads && Count() == threads;
}

//------------------------------------------------------------------------------
bool BenchmarkThreads::Turn(int threads)
{
  return Use(threads) && Use(1) && Use(threads) && Use(1);
}

//------------------------------------------------------------------------------
std::string BenchmarkThreads::Ask(const std::string& arguments)
{
  std::error_code error;
  const std::string program = std::filesystem::read_symlink("/proc/self/exe", error).string();
  std::FILE* pipe = error ? nullptr : popen(("'" + program + "' " + arguments).c_str(), "r");
  std::string last;
  char line[256];
  while (pipe && std::fgets(line, sizeof line, pipe))
  {
    last = line;
  }
  if (pipe)
  {
    pclose(pipe);
  }
  return last;
}
