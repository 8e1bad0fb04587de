#ifndef VTKVersions_h
#define VTKVersions_h

// Every difference between the VTK versions we support (9.1 to 9.6) is decided here.

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <array>

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

/// The type of each cell; null where the grid holds them otherwise, as it may from VTK 9.6 on.
inline vtkUnsignedCharArray* GetTypesOfCells(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return vtkUnsignedCharArray::SafeDownCast(grid->GetCellTypes());
#else
  return grid->GetCellTypesArray();
#endif
}

/// The arrays that hold the faces of polyhedra; null where there are none.
inline std::array<vtkObject*, 2> GetFaceArrays(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  return { grid->GetPolyhedronFaces(), grid->GetPolyhedronFaceLocations() };
#else
  return { grid->GetFaces(), grid->GetFaceLocations() };
#endif
}

/// Whether the list of faces of a polyhedron lies within its arrays, so that
/// vtkUnstructuredGrid::GetFaceStream, which does not look, can read it. From any thread.
inline bool HasFaceStream(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* scratch)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  vtkCellArray* faces = grid->GetPolyhedronFaces();
  vtkCellArray* locations = grid->GetPolyhedronFaceLocations();
  if (!faces || !locations || cell >= locations->GetNumberOfCells())
  {
    return false;
  }
  locations->GetCellAtId(cell, scratch);
  return std::all_of(scratch->begin(), scratch->end(),
    [faces](vtkIdType face) { return face >= 0 && face < faces->GetNumberOfCells(); });
#else
  (void)scratch;
  vtkIdTypeArray* faces = grid->GetFaces();
  vtkIdTypeArray* locations = grid->GetFaceLocations();
  if (!faces || !locations || cell >= locations->GetNumberOfValues())
  {
    return false;
  }
  const vtkIdType size = faces->GetNumberOfValues();
  vtkIdType at = locations->GetValue(cell);
  bool within = at >= 0 && at < size;
  for (vtkIdType left = within ? faces->GetValue(at++) : 0; left > 0 && within; --left)
  {
    const vtkIdType count = at < size ? faces->GetValue(at) : -1;
    within = count >= 0 && count < size - at;
    at += 1 + count;
  }
  return within;
#endif
}

#endif
