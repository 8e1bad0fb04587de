/**
 * Tetrahedra as the tiles read them: built once per mesh, plain arrays.
 *
 * Cells lie along a Morton curve and points in the order of their first use, so that what a tile
 * reads lies close together. Corners ascend, so that two cells find the same numbers for the plane
 * of a face that they share. Face f is opposite corner f.
 */
#ifndef TileMesh_h
#define TileMesh_h

#include <cstddef>
#include <functional>
#include <vector>

class TileMesh
{
public:
  /** Is given the share that is done, from 0 to 1. */
  using Progress = std::function<void(double share)>;

  /** `points`: x, y, z and an unused fourth each; `corners`: 4 point ids per cell. */
  void Build(
    const std::vector<float>& points, const std::vector<int>& corners, const Progress& report);

  /** One per point or per cell of what Build was given. */
  void SetScalars(const std::vector<float>& values, bool onePerCell);

  /** One per cell of what Build was given: cells with 0 only take part in the order, and where they
   *  are most they do not even that (IsSparse). False where nothing changes. */
  bool SetDrawn(const std::vector<unsigned char>& drawn);

  /** The corners of the face opposite corner f, ascending, and whether their normal points into a cell of
   *  positive orientation. */
  static constexpr int FaceCorners[4][3] = { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } };
  static constexpr bool IsInward(int face) { return face % 2 == 1; }

  int GetNumberOfCells() const { return static_cast<int>(this->Source.size()); }
  int GetNumberOfPoints() const { return static_cast<int>(this->Points.size() / 4); }
  std::size_t GetMemorySize() const;

  /** x, y, z, scalar. */
  std::vector<float> Points;
  std::vector<int> Corners;
  /** Across each face; -1 where there is none. */
  std::vector<int> Neighbours;
  /** 1 where corner 3 lies before the face of corners 0, 1, 2 in the right-hand sense, -1 behind
   *  it, 0 for a flat cell. */
  std::vector<signed char> Orientations;
  std::vector<unsigned char> Drawn;
  /** Whether so few are drawn that the others are not worth a look. */
  bool IsSparse = false;
  /** Whether some are not drawn and yet take part in the order. */
  bool OrdersEmpty = false;
  /** Bit f: on the other side of face f the scalar may be another one, or there is no cell. Folded: the
   *  cell is flat, or a neighbour lies on the same side of their face. */
  std::vector<unsigned char> Steps;
  static constexpr unsigned char Folded = 16;
  /** The cell's id in what Build was given. */
  std::vector<int> Source;
  /** The point's id in what Build was given. */
  std::vector<int> PointSource;
  /** Empty where scalars are the points'. */
  std::vector<float> CellScalars;

private:
  void OrderCells(const std::vector<float>& points, const std::vector<int>& corners);
  void CopyCells(const std::vector<float>& points, const std::vector<int>& corners);
  void FindOrientations();
  void FindSteps();
  bool IsFolded(int cell) const;
};

#endif
