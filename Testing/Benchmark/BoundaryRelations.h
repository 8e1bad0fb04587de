/**
 * The visibility order of a mesh that need not be convex: shared faces, and a BSP tree for what
 * gaps separate.
 *
 * Paper: Comba et al., Fast Polyhedral Cell Sorting for Interactive Rendering of Unstructured
 * Grids, 1999 (BSP-XMPVO). The fragments of the boundary are visited from the farthest on. A cell
 * may be drawn when the cells behind its faces are, and when every part of its boundary through
 * which a ray enters it has been visited. Where a ray leaves a cell that cannot be drawn yet
 * (partially projected), the cell is kept in a list, and cells entered in front of it wait for it:
 * where the two fragments overlap as the eye sees them.
 *
 * Right for every mesh without a circle, to rounding in the cuts of the tree. Cells left over by a
 * circle come last, farthest centre first.
 */
#ifndef BoundaryRelations_h
#define BoundaryRelations_h

#include "BoundaryBSP.h"
#include "CellComplex.h"
#include "vtkType.h"

#include <array>
#include <vector>

class BoundaryRelations
{
public:
  /** The complex must stay as it is. */
  void Build(const CellComplex& complex);

  /** All cells, farthest first. `eye`: as for ExactOrientation::SideOfEye. */
  void Sort(const double eye[4], std::vector<vtkIdType>& order);

  /** Cells that a circle left over, in the last sort. */
  int GetNumberOfLeftCells() const { return this->LeftCells; }
  /** Relations that partially projected cells added in the last sort. */
  int GetNumberOfAddedRelations() const { return static_cast<int>(this->Added.size()); }
  const BoundaryBSP& GetTree() const { return this->Tree; }

private:
  struct Plane
  {
    double Normal[3];
    double Offset;
    double Error;
  };
  /** To a cell across a contact. */
  struct Link
  {
    int Neighbor;
    int Contact;
    /** 1 where this cell lies on the side to which the contact's normal points. */
    int Side;
  };
  struct Relation
  {
    int Nearer;
    int Next;
  };

  /** What a fragment looks like to the eye, at most: a cone about a direction; in parallel
   *  projection a disk about a point of the image, of radius Sine. */
  struct Shape
  {
    double Axis[3];
    double Sine, Cosine;
  };

  void SetPlanes();
  void FindSpheres();
  void FindShapes(const double eye[4]);
  bool MayOverlap(bool parallel, int first, int second) const;
  void LinkCells();
  void FindSigns(const double eye[4]);
  void CountWaiting();
  void VisitBoundary(const double eye[4], std::vector<vtkIdType>& order);
  void WaitForPartlyProjected(const double eye[4], int fragment, int cell);
  bool Overlap(const double eye[4], int first, int second) const;
  /** Whether the plane has one on one side and the other on the other. */
  bool Separates(const double normal[3], const double origin[3], const BoundaryBSP::Fragment& a,
    const BoundaryBSP::Fragment& b) const;
  bool AnEdgeSeparates(
    const double eye[4], const BoundaryBSP::Fragment& a, const BoundaryBSP::Fragment& b) const;
  bool CornersSeparate(
    const double eye[4], const BoundaryBSP::Fragment& a, const BoundaryBSP::Fragment& b) const;
  void Release(int cell, std::vector<vtkIdType>& order);
  void AppendLeft(const double eye[4], std::vector<vtkIdType>& order);

  const CellComplex* Complex = nullptr;
  BoundaryBSP Tree;
  std::vector<Plane> Planes;
  std::vector<Link> Links;
  std::vector<int> LinkOffsets;

  /** About each fragment: centre and radius. */
  std::vector<std::array<double, 4>> Spheres;

  std::vector<signed char> Signs;
  std::vector<Shape> Shapes;
  std::vector<BoundaryBSP::Visit> Visits;
  std::vector<int> Waiting;
  std::vector<char> Drawn;
  std::vector<int> Stack;
  /** Fragments through which rays leave cells that are not drawn yet. */
  std::vector<int> Partly;
  /** Lists of relations, one per cell: the first of each, or -1. */
  std::vector<int> FirstAdded;
  std::vector<Relation> Added;
  int LeftCells = 0;
};

#endif
