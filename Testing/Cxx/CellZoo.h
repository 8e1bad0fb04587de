#ifndef CellZoo_h
#define CellZoo_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <vector>

class vtkUnstructuredGrid;

/// A lattice of unit cubes, each as cells of some kind, such that neighbours share their points.
namespace CellZoo
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Map = std::function<void(double x[3])>;

/// The ways to fill a cube. Wedges and prisms cut along the same diagonal as tetrahedra.
enum Kind
{
  Hexahedron,
  Voxel,
  Tetrahedra,
  Wedges,
  Pyramids,
  Polyhedron,
  PointSet,
  QuadraticHexahedron,
  TriquadraticHexahedron,
  BiquadraticQuadraticHexahedron,
  LagrangeHexahedron,
  BezierHexahedron,
  QuadraticTetrahedra,
  LagrangeTetrahedra,
  BezierTetrahedra,
  QuadraticWedges,
  BiquadraticQuadraticWedges,
  LagrangeWedges,
  BezierWedges,
  QuadraticPyramids,
  NumberOfKinds
};
constexpr int FirstCurved = QuadraticHexahedron;

/// Cubes along x, y and z; `kinds` by cube, x fastest. Point data "scalar": `field` at each point.
Grid Make(const int size[3], const std::vector<int>& kinds,
  const std::function<double(const double x[3])>& field);

/// A row of cubes in which every two kinds stand side by side.
std::vector<int> AllPairs();

/// The type of a kind's cells.
int TypeOf(int kind);

/// One cell of any type that has a volume, its points where VTK's reference cell has them; Lagrange
/// and Bezier cells of the given degree.
Grid Reference(int type, int degree = 2);
/// The types that Reference knows.
const std::vector<int>& AllTypes();

/// How often each triangle of a face is used: faces as fans from their smallest ids.
struct FaceUses
{
  vtkIdType Once = 0;
  vtkIdType Twice = 0;
  vtkIdType More = 0;
  double AreaOfOnce = 0.0;
};
FaceUses CountFaceUses(vtkUnstructuredGrid* grid);
}

#endif
