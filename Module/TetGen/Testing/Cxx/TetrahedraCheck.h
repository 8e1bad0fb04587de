#ifndef TetrahedraCheck_h
#define TetrahedraCheck_h

#include "vtkType.h"

#include <vector>

class vtkObject;
class vtkUnstructuredGrid;

/// What the tests ask of tetrahedra; by sums and comparisons of its own, none of the module's.
namespace TetrahedraCheck
{
struct Faces
{
  /// Triangles that one cell has.
  vtkIdType Boundary = 0;
  /// Triangles that two cells have, from either side.
  vtkIdType Inner = 0;
  /// All others: cracks would be among the boundary, overlaps are here.
  vtkIdType Wrong = 0;
  double BoundaryArea = 0.0;
};

Faces CountFaces(vtkUnstructuredGrid* tetrahedra);

/// The boundary's triangles by coordinates, so that numberings do not matter: sorted.
std::vector<std::vector<double>> BoundaryTriangles(vtkUnstructuredGrid* tetrahedra);

/// By SourceCell; the last entry is what has none.
std::vector<double> VolumesBySource(vtkUnstructuredGrid* tetrahedra, vtkIdType cells);

/// Of the convex hull of all points that cells have, as the cutting planes find it.
double HullVolume(vtkUnstructuredGrid* grid);

/// A point array "linear", 3 x - 2 y + z + 1.
void AddLinear(vtkUnstructuredGrid* grid);
/// How far it is off at any point.
double LinearError(vtkUnstructuredGrid* grid);

/// Counts warnings and errors of an object instead of printing them.
class Messages
{
public:
  explicit Messages(vtkObject* object);
  int Warnings = 0;
  int Errors = 0;
};
}

#endif
