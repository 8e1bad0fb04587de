/**
 * The tetrahedra that the star of a point becomes when the point is moved onto a neighbour: cones
 * from there over the faces of the star that do not touch it.
 *
 * Where the point is inside, the star is a polyhedron; if all cones are positive, the neighbour
 * sees all of it, and they fill it: the mesh stays one, whatever it was like. A place in the star
 * lies in the cone between whose three inner planes it is.
 */
#ifndef CollapsedStar_h
#define CollapsedStar_h

#include "CollapsibleMesh.h"

class CollapsedStar
{
public:
  /** Of a place: the cone, and the weights of its corners: the apex', then those of its base. */
  struct Location
  {
    int Cone = 0;
    double Weights[4] = { 1.0, 0.0, 0.0, 0.0 };
    /** Outside of all cones: the weights are then those of the nearest place of them. */
    bool IsOutside = false;
  };

  /** False where a cone is no better than `leastQuality`. `star`: of the point that moves. */
  bool Build(
    const CollapsibleMesh& mesh, int to, const std::vector<int>& star, double leastQuality);

  /** `guess`: the cone to look into first. */
  void Locate(const double x[3], int guess, Location& location) const;

  int GetNumberOfCones() const { return static_cast<int>(this->Cones.size()); }
  int GetTetrahedron(int cone) const { return this->Cones[cone].Corner / 4; }
  /** Which cone is a tetrahedron of the star; `otherwise` where that one goes. */
  int FindCone(int tetrahedron, int otherwise) const;
  /** Points of the cone, in the order of a location's weights. */
  const int* GetPoints(int cone) const { return this->Cones[cone].Points; }
  /** Their places in the tetrahedron. */
  const int* GetPlaces(int cone) const { return Places[this->Cones[cone].Corner % 4]; }

  /** Six volumes by the cube of the longest edge at the first point. */
  static double QualityOf(
    const double apex[3], const double a[3], const double b[3], const double c[3]);

private:
  static constexpr int Places[4][4] = { { 0, 1, 2, 3 }, { 1, 0, 3, 2 }, { 2, 0, 1, 3 },
    { 3, 0, 2, 1 } };

  struct Cone
  {
    int Corner;
    int Points[4];
    /** Rows: the weights of the base's corners for a place relative to the apex. */
    double Inverse[3][3];
  };

  bool AddCone(const CollapsibleMesh& mesh, int apex, int corner, double leastQuality);

  void LocateNearest(const double x[3], Location& location) const;

  const CollapsibleMesh* Mesh = nullptr;
  std::vector<Cone> Cones;
  double Apex[3] = { 0.0, 0.0, 0.0 };
};

#endif
