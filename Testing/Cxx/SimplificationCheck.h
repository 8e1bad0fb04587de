#ifndef SimplificationCheck_h
#define SimplificationCheck_h

#include <string>

class vtkUnstructuredGrid;

/// What a simplified mesh is measured by, with nothing of the simplifier.
namespace SimplificationCheck
{
/// The largest difference of the scalar at the points of `original` and at the middles of its
/// tetrahedra, as a share of its range; outside of `simplified` at its nearest boundary place.
double FieldError(vtkUnstructuredGrid* original, vtkUnstructuredGrid* simplified);

/// The largest distance of the points and the middles of the boundary triangles of `original` from
/// the boundary of `simplified`, as a share of the diagonal.
double BoundaryError(vtkUnstructuredGrid* original, vtkUnstructuredGrid* simplified);

struct Shape
{
  double Volume = 0.0;
  double BoundaryArea = 0.0;
  /// Points, less edges, plus triangles, less tetrahedra; and of the boundary.
  long long Euler = 0;
  long long BoundaryEuler = 0;
  /// Tetrahedra that are not positive, faces that are not of one or of two facing tetrahedra.
  int Wrong = 0;
};

Shape Measure(vtkUnstructuredGrid* tetrahedra);

/// Simplifies tetrahedra and checks everything that must hold, whatever they are; the share of them
/// that is left.
double Check(const std::string& name, vtkUnstructuredGrid* original, double field, double boundary);
}

#endif
