#include "vtkConvexCells.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkConvexCells);
