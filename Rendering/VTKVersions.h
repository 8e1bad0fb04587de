#ifndef VTKVersions_h
#define VTKVersions_h

// Every difference between the VTK versions we support (9.1 to 9.6) is decided here.

// VTK 9.4 replaced GLEW by glad.
#if __has_include(<vtk_glad.h>)
#include <vtk_glad.h>
#else
#include <vtk_glew.h>
#endif

#endif
