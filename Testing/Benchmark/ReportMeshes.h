#ifndef ReportMeshes_h
#define ReportMeshes_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkUnstructuredGrid;

/// The report's meshes: hexahedra with a point scalar each.
namespace ReportMeshes
{
struct Mesh
{
  std::string Name;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  /// Percents of field error that it is simplified by, those of Cignoni's table 4 where it has them.
  std::vector<double> Levels;
};

/// Blunt Fin, Bucky ball, disk_out_ref and the fire plume from `folder`, those of `names` that are
/// there; a line says which are not.
std::vector<Mesh> Read(const std::string& folder, const std::vector<std::string>& names);

/// A bent lattice of cells^3 hexahedra with waves for a scalar, with levels where asked for.
Mesh MakeLattice(int cells, const std::vector<double>& levels = {});
}

#endif
