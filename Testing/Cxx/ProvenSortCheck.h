#ifndef ProvenSortCheck_h
#define ProvenSortCheck_h

#include "RayOrder.h"
#include "SortTesting.h"

#include <string>
#include <vector>

class vtkProvenVisibilitySort;

/// Checks what a sort says of its order, and the order, eye by eye on one mesh.
class ProvenSortCheck
{
public:
  /// What must hold beyond the proof: a proven order is right on every ray, every order is a
  /// permutation of the cells that are not imaginary.
  struct Demands
  {
    /// No ray may be wrong, groups that hide each other in a circle let off among themselves.
    bool RightOnRays = true;
    /// No misordered face but where there is a circle.
    bool NoMisorderedFaces = true;
    /// No circle at all, and every order proven.
    bool Proven = false;
  };

  ProvenSortCheck(const std::string& name, vtkUnstructuredGrid* grid);

  /// The number of eyes at which a demand does not hold; says which, and what was found.
  int CountFailures(
    vtkProvenVisibilitySort* sort, std::vector<SortTesting::Eye> eyes, const Demands& demands);

  /// Says nothing more.
  void BeQuiet() { this->Quiet = true; }
  void SetNumberOfRays(int rays) { this->NumberOfRays = rays; }

  /// Over all eyes so far.
  int GetNumberOfEyes() const { return this->Eyes; }
  int GetNumberOfProvenEyes() const { return this->ProvenEyes; }
  int GetNumberOfCyclicEyes() const { return this->CyclicEyes; }
  /// The most cells that were in groups for one eye, and the most rays that would have been wrong
  /// had these not been let off.
  vtkIdType GetMostCyclicCells() const { return this->MostCyclicCells; }
  int GetMostRaysLetOff() const { return this->MostRaysLetOff; }
  /// The most rays of one eye on which no order is right: cells overlap there, or elsewhere.
  int GetMostOverlappingRays() const { return this->MostOverlappingRays; }
  int GetMostCrossingRays() const { return this->MostCrossingRays; }
  const RayOrder& GetRays() const { return this->Rays; }

private:
  bool HoldsAt(vtkProvenVisibilitySort* sort, SortTesting::Eye& eye, const Demands& demands);
  std::vector<int> GroupsOf(vtkProvenVisibilitySort* sort) const;

  std::string Name;
  vtkUnstructuredGrid* Mesh;
  RayOrder Rays;
  vtkIdType DrawableCells;
  bool Quiet = false;
  int NumberOfRays = 2000;
  int Eyes = 0;
  int ProvenEyes = 0;
  int CyclicEyes = 0;
  vtkIdType MostCyclicCells = 0;
  int MostRaysLetOff = 0;
  int MostOverlappingRays = 0;
  int MostCrossingRays = 0;
};

#endif
