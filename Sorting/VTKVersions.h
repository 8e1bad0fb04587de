#ifndef VTKVersions_h
#define VTKVersions_h

// Every difference between the VTK versions we support (9.1 to 9.6) is decided here.

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

// VTK 9.4 replaced GLEW by glad. Named, not included: what sorts has no OpenGL.
#if __has_include(<vtk_glad.h>)
#define CELLPROJECTION_OPENGL_HEADER <vtk_glad.h>
#else
#define CELLPROJECTION_OPENGL_HEADER <vtk_glew.h>
#endif

/// Whether the user wants `filter` to stop; from VTK 9.3 on a filter upstream that stopped counts
/// too.
inline bool IsAborted(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

#endif
