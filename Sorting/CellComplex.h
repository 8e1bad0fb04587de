/**
 * Cells, the triangles through which they touch, and the boundary: what every sort works on.
 *
 * Plain arrays. Coincident points are one point. A face of more than three corners is its
 * triangles, FaceTriangles: where such a face is planar, within 1e-12 of the
 * mesh's diagonal, one of them speaks for all; where it is warped each speaks for itself.
 */
#ifndef CellComplex_h
#define CellComplex_h

#include "vtkBoundingBox.h"

#include <vector>

struct CellComplex
{
  /** A triangle with a cell on either side: Cells[0] on the side to which
   *  (p1 - p0) x (p2 - p0) points, Cells[1] on the other. Point ids ascend, so that any two
   *  contacts of the same triangle have the same sign for an eye to the last bit. */
  struct Contact
  {
    int Points[3];
    int Cells[2];
  };

  /** A triangle of one cell; (p1 - p0) x (p2 - p0) points out of it. */
  struct BoundaryTriangle
  {
    int Points[3];
    int Cell;
  };

  /** Three per point, exactly as the input has them. */
  std::vector<double> Points;
  /** Three per cell: the mean of its corners. */
  std::vector<double> Centers;
  /** About the centres. */
  vtkBoundingBox CenterBox;
  int NumberOfCells = 0;

  std::vector<Contact> Contacts;
  std::vector<BoundaryTriangle> Boundary;

  /** Triangles that more than two cells share. Every cell on one side touches every one on the
   *  other. */
  int NumberOfNonManifoldFaces = 0;
  /** Triangles whose cells lie on the same side: they overlap, and no contact orders them. */
  int NumberOfOverlappingFaces = 0;
  /** Pairs of cells that touch in faces that do not match (T-junctions); no contact orders them. */
  int NumberOfNonconformingPairs = 0;

  /** Whether the cells are a complex, as far as their faces tell. */
  bool IsComplex() const
  {
    return this->NumberOfNonManifoldFaces == 0 && this->NumberOfOverlappingFaces == 0 &&
           this->NumberOfNonconformingPairs == 0;
  }
  /** The diagonal of the box about the centres. */
  double GetSize() const
  {
    return this->CenterBox.IsValid() ? this->CenterBox.GetDiagonalLength() : 0.0;
  }
};

#endif
