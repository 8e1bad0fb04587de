/**
 * Points, tetrahedra and data of an output from those of a mesh.
 */
#ifndef TransferredData_h
#define TransferredData_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataSetAttributes;
class vtkUnstructuredGrid;

/** A point that the mesh does not have: its place, and whose data it takes by which weights. */
struct NewPoint
{
  std::array<double, 3> Position;
  /** None: data of 0. */
  std::vector<vtkIdType> Ids;
  std::vector<double> Weights;
};

struct TetrahedraOutput
{
  /** Corners: points of the mesh, then the new ones. */
  std::vector<std::array<int, 4>> Tetrahedra;
  /** Of the input, per tetrahedron; -1 for none. */
  std::vector<vtkIdType> SourceCells;
  std::vector<NewPoint> NewPoints;
  /** Leave out points of the mesh that no tetrahedron has. */
  bool UsedPointsOnly = false;
};

namespace TransferredData
{
/** Points and their data come from `mesh`, cell data from `cells`, those of the input. */
void Fill(const TetrahedraOutput& tetrahedra, vtkUnstructuredGrid* mesh,
  vtkDataSetAttributes* cells, vtkUnstructuredGrid* output);
}

#endif
