/**
 * How far a straight piece of a curved cell is off, in space and in the data.
 *
 * Edges are looked at in three or seven places, faces and insides in their middles. What a place is
 * off in space is its distance from the line or plane; its data are compared with the linear ones
 * at its foot there, so that the pace of the shape functions along a straight edge does not count.
 * Within a cell space counts as on its faces: else tetrahedra there turn over.
 */
#ifndef CurvedError_h
#define CurvedError_h

#include "CurvedCell.h"
#include "MarkedEdges.h"

#include <vector>

class ConvexCellPoints;
class vtkDataArray;

/** The data that are to be met, and how closely. */
class CurvedTolerance
{
public:
  /** `tolerance`: of the size of the mesh and of each component's range. */
  CurvedTolerance(const ConvexCellPoints& points, const std::vector<vtkDataArray*>& arrays,
    double tolerance);

  /** Of an input point, in units of what is tolerated. */
  const double* GetValues(vtkIdType point) const
  {
    return this->Values.data() + point * this->NumberOfValues;
  }
  int GetNumberOfValues() const { return this->NumberOfValues; }
  double GetDistance() const { return this->Distance; }

private:
  double Distance;
  int NumberOfValues = 0;
  std::vector<double> Values;
};

/** For one thread. */
class CurvedError
{
public:
  CurvedError(vtkUnstructuredGrid* grid, const CurvedTolerance& tolerance)
    : Cell(grid)
    , Tolerance(tolerance)
  {
  }

  /** Whether an edge is to be halved. `closely`: look in seven places. */
  bool IsCurved(const MarkedEdges::Tetrahedron& tetrahedron, int edge, bool closely);
  /** An edge to halve for the sake of a face or the inside; -1 where there is none. */
  int FindLongestOfCurved(const MarkedEdges::Tetrahedron& tetrahedron);

private:
  using Coordinates = CurvedCell::Coordinates;
  struct Sample
  {
    Coordinates X;
    std::vector<double> Values;
  };
  void Take(const Coordinates& reference, Sample& sample);
  bool IsOff(const MarkedEdges::Tetrahedron& tetrahedron, const int* corners, int count,
    const double* shares);
  double SquaredLength(int a, int b) const;

  CurvedCell Cell;
  const CurvedTolerance& Tolerance;
  Sample Corners[4];
  Sample Place;
};

#endif
