#include "BlendModeAdvice.h"

#include "vtkConvexCellMapper.h"

//------------------------------------------------------------------------------
const char* BlendModeAdvice(int mode)
{
  switch (mode)
  {
    case vtkConvexCellMapper::COMPOSITE:
      return "use vtkPreIntegratedTetrahedraMapper";
    case vtkConvexCellMapper::MAXIMUM_INTENSITY:
    case vtkConvexCellMapper::MINIMUM_INTENSITY:
      return "use vtkMaximumProjectionMapper";
    case vtkConvexCellMapper::ADDITIVE:
      return "use vtkProjectedPolyhedraMapper";
    case vtkConvexCellMapper::ISOSURFACE:
      return "use vtkBarycentricShellMapper";
    default:
      return "the modes are 0, 1, 2, 4 and 5";
  }
}
