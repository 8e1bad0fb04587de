/**
 * Fewer tetrahedra with the same field within a bound.
 *
 * An edge is collapsed onto one of its ends (the points that stay do not move) where every sample
 * of the original in the star keeps its value within the bound: the samples are the original's
 * points and the middles of its tetrahedra. Between rounds over all points the scalars of the
 * points that are left are shifted so that the largest errors on either side of zero are equal:
 * that makes room for the next round (Cignoni, Costanza, Montani, Rocchini, Scopigno,
 * Simplification of Tetrahedral Meshes with Accurate Error Evaluation, 2000, collapse with the
 * scalars as they are).
 *
 * Passes: shortest edges of a point first; the boundary's say (BoundaryPatch), the cones' (they
 * must be positive, and no worse than the star was or LeastQuality: CollapsedStar), the samples'.
 * All is the same whatever the machine. Where the boundary is moved, samples can come to lie
 * outside: their value is that of the surface nearby, and they are listed for the caller to look at
 * again.
 */
#ifndef TetrahedraSimplification_h
#define TetrahedraSimplification_h

#include "BoundaryPatch.h"
#include "CollapsedStar.h"
#include "CollapsibleMesh.h"
#include "FieldSamples.h"

#include <functional>
#include <utility>
#include <vector>

struct SimplificationSettings
{
  /** Of the scalar, and of the distance of the boundary. */
  double FieldBound = 0.0;
  double BoundaryBound = 0.0;
  bool ShiftsScalars = true;
  /** Called with 0 .. 1; false ends the work. */
  std::function<bool(double)> Progress;
};

class TetrahedraSimplification
{
public:
  /** `points`: three per point, best about the origin; `scalars`: one per point; positive
   *  tetrahedra. */
  TetrahedraSimplification(std::vector<double> points, std::vector<double> scalars,
    std::vector<CollapsibleMesh::Tetrahedron> tetrahedra, const SimplificationSettings& settings);

  /** False where the work was ended. */
  bool Run();

  // === What is left ===

  const CollapsibleMesh& GetMesh() const { return this->Mesh; }
  /** By point of the input. */
  const std::vector<double>& GetScalars() const { return this->Scalars; }
  /** The largest error at samples that lie in a tetrahedron. */
  double FindFieldError() const;
  double FindBoundaryError() const { return this->Boundary.FindLargestDistance(); }
  /** Samples outside of it, for GetSamples. */
  std::vector<int> FindOutside() const;
  const FieldSamples& GetSamples() const { return this->Samples; }

private:
  /** Where a sample is in the mesh. */
  struct Place
  {
    int Tetrahedron;
    bool IsOutside;
    /** Of the corners, at the nearest place of the tetrahedron where it is outside. */
    std::array<double, 4> Weights;
  };

  void TakeSamples();
  int RunRound(int round);
  bool TryPoint(int point);
  void FindNeighbors(int point);
  double FindLeastQuality(int point) const;
  bool KeepsField();
  bool KeepsOthers(int tetrahedron);
  bool KeepsSample(int sample, int& guess);
  double FindPlace(int sample, int& guess, Place& place) const;
  double ErrorOf(int sample, int tetrahedron) const;
  void Collapse(int point, int to);
  void ShiftScalars();
  void ShiftScalar(int point);
  bool Report(double progress) const;

  SimplificationSettings Settings;
  CollapsibleMesh Mesh;
  std::vector<double> Scalars;
  std::vector<double> Original;
  double Range[2] = { 0.0, 0.0 };
  BoundaryPatch Boundary;
  FieldSamples Samples;
  std::vector<Place> PlaceOf; // by sample
  CollapsedStar Cones;
  std::vector<int> Order;   // of the points
  std::vector<int> Changed; // by point: when its star has changed
  std::vector<int> Tried;   // by point
  int Clock = 1;

  // Of the point that is tried.
  int Point = -1;
  std::vector<int> Star;
  std::vector<std::array<double, 3>> Neighbors; // squared length, difference, point
  std::vector<int> Seen;                        // by point
  int Look = 0;
  std::vector<std::pair<int, Place>> Places; // of samples
  std::vector<std::pair<double, double>> Errors;
};

#endif
