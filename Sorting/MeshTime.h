/**
 * What a mesh's order depends on, as times: points, cells, and the marks of imaginary cells.
 *
 * New scalars move no cell and change none of these. One time for each, for an older object may
 * take another's place. Other data sets than unstructured grids have one time for everything.
 */
#ifndef MeshTime_h
#define MeshTime_h

#include "vtkType.h"

#include <array>

class vtkDataSet;

using MeshTime = std::array<vtkMTimeType, 6>;

MeshTime MeshTimeOf(vtkDataSet* input);

#endif
