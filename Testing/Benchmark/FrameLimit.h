#ifndef FrameLimit_h
#define FrameLimit_h

#include "vtkCommand.h"

#include <chrono>

class vtkRenderWindow;

/// Aborts a frame that takes too long; VTK's mappers ask for that.
class FrameLimit : public vtkCommand
{
public:
  static FrameLimit* New() { return new FrameLimit; }

  /// To be called once.
  void Watch(vtkRenderWindow* window, double seconds);
  void Execute(vtkObject* window, unsigned long event, void* data) override;

  /// Whether one was.
  bool WasExceeded = false;

private:
  double Seconds = 0.0;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

#endif
