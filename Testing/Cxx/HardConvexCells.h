#ifndef HardConvexCells_h
#define HardConvexCells_h

#include "vtkSmartPointer.h"

#include <random>

class vtkPoints;
class vtkUnstructuredGrid;

/// Random convex cells about a window of 128 x 128 pixels, each alone, of kinds that are hard to find the pixels of.
/// Points in [-1, 1], 64 pixels a unit where the view is parallel.
class HardConvexCells
{
public:
  enum Kind
  {
    Any,
    /// Faces with four corners bend.
    Warped,
    /// Corners in rows of pixels, in columns, on pixels; edges along them.
    OnRows,
    OnColumns,
    OnPixels,
    /// Corners next to rows of pixels, by a float's last digits.
    BesideRows,
    /// Of a row or a column of pixels, or less.
    Row,
    Column,
    /// Thinner than a pixel, in any direction.
    Slivers,
    /// What is before and behind lies close together.
    Flat,
    /// Long edges along rows of pixels, but for what is less than a float's last digits on the screen.
    AlongRows,
    NumberOfKinds
  };
  static const char* GetName(int kind);

  /// Tetrahedra, pyramids, wedges and hexahedra with a point scalar that is all but linear.
  static vtkSmartPointer<vtkUnstructuredGrid> Make(int kind, int count, unsigned int seed);

private:
  explicit HardConvexCells(unsigned int seed)
    : Generator(seed)
  {
  }
  double Random(double least, double greatest);
  void SetAxes(int kind);
  void MapPoint(int kind, const double (&reference)[3], double (&point)[3]);

  std::mt19937 Generator;
  double Center[3], Axes[3][3];
};

#endif
