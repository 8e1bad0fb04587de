/**
 * Convex cells in the order of their squared tangential distance from the eye.
 *
 * The power of a point x with regard to a sphere (c, R) is |x - c|^2 - R^2 = |x|^2 - h(x) with
 * h(x) = 2 c.x + (R^2 - |c|^2): an affine function, the one that takes the value |x|^2 at all
 * corners of a cell whose circumsphere this is. Hence the farthest cell has the smallest h(eye),
 * and no root or division is needed per frame. Along a ray between two cells that share a face,
 * their h are equal on the face, so that where every cell's sphere keeps clear of its neighbours'
 * corners (Delaunay) the order is right for every eye, holes in the mesh included.
 *
 * Papers: Max, Hanrahan, Crawfis, Area and Volume Coherence for Efficient Visualization of 3D
 * Scalar Functions, 1990; Cignoni, De Floriani, Power Diagram Depth Sorting, 1998; Karasick et al.,
 * Visualization of Three-Dimensional Delaunay Meshes, 1997. (Cignoni 1995, 3.1, compares lengths:
 * it is their squares, which can be negative, and the larger is behind.)
 *
 * Cells of one sphere, as the tetrahedra of a box, have one key and are sorted as one.
 *
 * All h are kept relative to the centre of the mesh and in units of its size, a power of two.
 * Not guaranteed: cells whose corners lie on no common sphere take the affine function that fits
 * |x|^2 best in the least-squares sense. Flat cells get a finite one that is of no other use.
 */
#ifndef PowerCells_h
#define PowerCells_h

#include "PowerLift.h"
#include "RadixSort.h"
#include "SharedSpheres.h"

#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class PowerCells
{
public:
  /** Forgets all cells. Bounds: those of the mesh, as in VTK. */
  void Initialize(vtkIdType numberOfCells, const double bounds[6]);

  /** Corners: `count` points of three coordinates each. May be called for different cells at the
   *  same time; not after the first sort. */
  void SetCell(vtkIdType cell, const double* corners, int count);

  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Lifts.size()); }

  /** Whether the corners lie on one finite sphere, up to the rounding of the coordinates' squares
   *  and of the lift itself. */
  bool IsCospherical(vtkIdType cell) const { return this->Cospherical[cell] != 0; }

  /** The smaller, the farther. The eye is a point (eye[3] = 1) or a direction towards it (0). Two
   *  keys compare only for the same eye. */
  double GetKey(vtkIdType cell, const double eye[4]) const;

  /** All cells, farthest first; equal keys in the order of the ids, cells of one sphere together.
   *  At most 2^32 cells. */
  void SortBackToFront(const double eye[4], std::vector<vtkIdType>& order);

private:
  /** The eye in the coordinates of the class, scaled so that no key overflows. */
  struct Eye
  {
    double X[4];
  };
  /** A sphere in a run of equal 32-bit keys. */
  struct Tie
  {
    double Key;
    std::uint32_t Sphere;
  };
  /** Where it begins and ends among the ties, and where its cells go. */
  struct Run
  {
    std::size_t Begin;
    std::size_t End;
    vtkIdType* To;
  };
  Eye Transform(const double eye[4]) const;
  const std::vector<PowerLift>& GetSpheres() const
  {
    return this->Shared.IsEmpty() ? this->Lifts : this->Shared.GetLifts();
  }
  void FindPlaces();
  vtkIdType CountCells(const RadixSort::Item* begin, const RadixSort::Item* end) const;
  void WriteRuns(const Eye& eye, const RadixSort::Item* items, const RadixSort::Item* end,
    vtkIdType* to) const;
  void WriteChunk(const Eye& eye, vtkIdType chunk, vtkIdType* order) const;
  void WriteShared(const Eye& eye, vtkIdType* order);
  void WriteTies(const Eye& eye, const std::vector<Run>& runs, std::vector<Tie>& ties) const;
  vtkIdType* WriteCells(std::uint32_t sphere, vtkIdType* order) const;

  double Center[3] = { 0.0, 0.0, 0.0 };
  double Scale = 1.0;
  std::vector<PowerLift> Lifts;
  std::vector<unsigned char> Cospherical;
  SharedSpheres Shared;
  bool HasShared = false;
  /** Where the cells of each chunk of the sorted items go, and the end. */
  std::vector<vtkIdType> Places;
  RadixSort Sort;
};

#endif
