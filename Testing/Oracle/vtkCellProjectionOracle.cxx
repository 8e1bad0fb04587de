#include "vtkCellProjectionOracle.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkCellProjectionOracle);
