#ifndef BenchmarkMachine_h
#define BenchmarkMachine_h

#include <string>

/// What figures are of.
struct BenchmarkMachine
{
  std::string Renderer; // what OpenGL calls itself
  std::string Processor;
  std::string Backend; // of vtkSMPTools
  int Threads = 0;     // all that it has
  std::string VTK;

  /// Opens a window. "unknown" for what cannot be told.
  static BenchmarkMachine Find();
  std::string Describe() const;
};

#endif
