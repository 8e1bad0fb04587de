#ifndef InstructionSetsBenchmark_h
#define InstructionSetsBenchmark_h

#include <string>

class vtkUnstructuredGrid;

/// Tiles by each set of instructions that this machine has and the kernels are compiled for, against VTK's projected
/// tetrahedra in the same run.
namespace InstructionSetsBenchmark
{
void Run(const std::string& name, vtkUnstructuredGrid* grid, int frames);
}

#endif
