#ifndef MapperMessages_h
#define MapperMessages_h

#include "vtkType.h"

#include <string>

class ScalarField;
class vtkDataArray;
class vtkPlaneCollection;
class vtkRenderer;
class vtkUnstructuredGridBase;

/// What a mapper says about its input and its renderer.
namespace MapperMessages
{
/// Why nothing can be drawn of it; empty where something can.
std::string InputProblem(vtkUnstructuredGridBase* input);

/// Likewise of a renderer.
std::string RendererProblem(vtkRenderer* renderer);

/// That there are more planes than clip; empty where all do.
std::string ExcessPlanes(vtkPlaneCollection* planes);

/// That so many have no volume as floats; empty where none has.
std::string FlatTetrahedra(vtkIdType count);

/// That so many cells hide each other in circles too large for class DepthLayers; empty for none.
std::string UnresolvedCells(vtkIdType count);

/// That opaque geometry hides nothing; empty where its depth was read.
std::string UnreadableDepth(bool isRead);

std::string NonFiniteScalars(vtkDataArray* array, const ScalarField& scalars);
}

#endif
