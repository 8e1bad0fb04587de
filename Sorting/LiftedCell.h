/**
 * The affine function that takes the value |x|^2 at the corners of a cell.
 *
 * Four corners or more, on one sphere: exact up to rounding, by elimination with complete pivoting,
 * which picks the corners that are farthest from lying in a plane. Corners on no common sphere: the
 * least-squares fit. Corners in a plane: finite, and marked.
 */
#ifndef LiftedCell_h
#define LiftedCell_h

struct LiftedCell
{
  double Gradient[3] = { 0.0, 0.0, 0.0 };
  double Constant = 0.0;
  /** All corners take their value, up to rounding, and they do not lie in a plane. */
  bool Cospherical = false;

  /** Corners: `count` points, three coordinates each, of magnitude 1e-100 to 1e100. */
  static LiftedCell Fit(const double (*corners)[3], int count);
};

#endif
