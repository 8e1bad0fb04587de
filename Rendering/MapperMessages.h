#ifndef MapperMessages_h
#define MapperMessages_h

#include <string>

class ScalarField;
class vtkDataArray;
class vtkUnstructuredGridBase;

/// What a mapper says about its input.
namespace MapperMessages
{
/// Why nothing can be drawn of it; empty where something can.
std::string InputProblem(vtkUnstructuredGridBase* input);

std::string NonFiniteScalars(vtkDataArray* array, const ScalarField& scalars);
}

#endif
