#ifndef BenchmarkThreads_h
#define BenchmarkThreads_h

#include <string>

/// The number of threads of vtkSMPTools: asked for, and counted. With VTK 9.6 and TBB a process that asked for fewer
/// never gets more again, whatever it asks for: there each number needs a process of its own.
namespace BenchmarkThreads
{
/// How many take part in a loop.
int Count();

/// Asks for as many.
void Set(int threads);

/// The same; true where as many take part.
bool Use(int threads);

/// Whether one process can draw with these numbers of threads in turns. Leaves it with one.
bool Turn(int threads);

/// The last line that this program prints in a process of its own, with these arguments.
std::string Ask(const std::string& arguments);
}

#endif
