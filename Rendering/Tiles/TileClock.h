/**
 * Where the time of a frame by Tiles goes, stage by stage: off by default, and then a lap is one test.
 *
 * Between Begin and End the stages share the time by the processor's ticks, which cost a third of a
 * question to the system's clock. One clock serves one thread.
 */
#ifndef TileClock_h
#define TileClock_h

#include "TileStages.h"

#include <chrono>

#if defined(__x86_64__) || defined(_M_X64)
#ifdef _MSC_VER
#include <intrin.h>
#else
#include <x86intrin.h>
#endif
#endif

class TileClock
{
public:
  using Wall = std::chrono::steady_clock;

  void Begin(bool isOn)
  {
    this->IsOn = isOn;
    if (isOn)
    {
      this->Laps = TileStages();
      this->Start = Wall::now();
      this->Last = CountTicks();
    }
  }

  /** What has passed since the lap before belongs to `stage`. */
  void Lap(TileStages::Stage stage)
  {
    if (this->IsOn)
    {
      const long long now = CountTicks();
      this->Laps.Seconds[stage] += static_cast<double>(now - this->Last);
      this->Last = now;
    }
  }

  /** Adds the time since Begin to the stages. */
  void End()
  {
    if (this->IsOn)
    {
      this->Lap(TileStages::Other);
      const double seconds = std::chrono::duration<double>(Wall::now() - this->Start).count();
      const double ticks = this->Laps.GetSum();
      this->Stages.Add(this->Laps, ticks > 0.0 ? seconds / ticks : 0.0);
    }
  }

  bool GetIsOn() const { return this->IsOn; }

  /** What End has added. */
  TileStages Stages;

private:
  static long long CountTicks()
  {
#if defined(__x86_64__) || defined(_M_X64)
    return static_cast<long long>(__rdtsc());
#else
    return static_cast<long long>(Wall::now().time_since_epoch().count());
#endif
  }

  bool IsOn = false;
  TileStages Laps; // in ticks
  Wall::time_point Start;
  long long Last = 0;
};

#endif
