#ifndef FrameStatistics_h
#define FrameStatistics_h

#include "vtkType.h"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

class vtkTable;

/**
 * @class FrameStatistics
 * @brief What the last frame drew and how long its stages took; see vtkConvexCellMapper.
 */
class FrameStatistics
{
public:
  std::string Method;
  std::string Engine;
  vtkIdType CellsIn = 0;
  vtkIdType CellsDrawn = 0;
  vtkIdType CellsSkippedTransparent = 0;
  vtkIdType CellsSkippedInvalid = 0;
  vtkIdType CellsSkippedOutside = 0;
  vtkIdType Cycles = 0;
  vtkIdType MisorderedFaces = 0;
  vtkIdType RepairedPixels = 0;
  double SecondsPrepare = 0.0;
  double SecondsSort = 0.0;
  double SecondsProject = 0.0;
  double SecondsBlend = 0.0;
  /// Pixels from ray to ray.
  double ImageSampleDistance = 1.0;
  /// Names and numbers that a mapper was asked for.
  std::vector<std::pair<std::string, double>> Further;

  /// One row, the columns named as the members, in their order; the last one where it is above 1,
  /// and Further.
  void FillTable(vtkTable* table) const;

  /// Adds the seconds of its life to one of the members above.
  class Timer
  {
  public:
    explicit Timer(double& seconds)
      : Seconds(seconds)
      , Start(std::chrono::steady_clock::now())
    {
    }
    ~Timer()
    {
      const auto elapsed = std::chrono::steady_clock::now() - this->Start;
      this->Seconds += std::chrono::duration<double>(elapsed).count();
    }
    Timer(const Timer&) = delete;
    void operator=(const Timer&) = delete;

  private:
    double& Seconds;
    std::chrono::steady_clock::time_point Start;
  };
};

#endif
