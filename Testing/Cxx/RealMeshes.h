#ifndef RealMeshes_h
#define RealMeshes_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkUnstructuredGrid;

/// Meshes from the pinned data.
namespace RealMeshes
{
/// bluntFin, comb, post (PLOT3D hexahedra), can, fire, diskOut; null where CELLPROJECTION_DATA does
/// not have the files, or this VTK no reader. Says why.
vtkSmartPointer<vtkUnstructuredGrid> Read(const std::string& name);

/// One grid of all the blocks that a reader found, with the data that they share.
vtkSmartPointer<vtkUnstructuredGrid> Append(vtkDataObject* data);
}

#endif
