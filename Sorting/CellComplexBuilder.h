/**
 * Finds which cells touch through which triangles.
 *
 * Method: triangles are put in bins by their smallest point id, all threads at once, and matched
 * within each. Linear in the number of triangles; the result does not depend on the threads.
 */
#ifndef CellComplexBuilder_h
#define CellComplexBuilder_h

#include "CellComplex.h"
#include "CellFaces.h"

class CellComplexBuilder
{
public:
  /** Fills contacts, boundary and counts; points, centres with their box and the number of cells
   *  stay as they are. */
  static void Build(const std::vector<FaceTriangle>& triangles, CellComplex& complex);

private:
  /** What one bin gives. */
  struct Counts
  {
    int Contacts = 0;
    int Boundary = 0;
    int NonManifold = 0;
    int Overlapping = 0;
  };
  using Range = FaceTriangle*;

  CellComplexBuilder(const std::vector<FaceTriangle>& triangles, CellComplex& complex);
  void FillBins(const std::vector<FaceTriangle>& triangles);
  void Match(bool store);
  Counts MatchBin(int point, const Counts& offsets, bool store);
  Counts MatchGroup(Range begin, Range end, const Counts& offsets, bool store);
  Counts MatchPairs(Range begin, Range end, const Counts& offsets, bool store);
  void StoreContact(int at, const FaceTriangle& above, const FaceTriangle& below);
  void StoreBoundary(int at, const FaceTriangle& triangle);
  void DropCoplanarContacts();

  CellComplex& Complex;
  std::vector<FaceTriangle> Sorted;
  std::vector<int> Bins;
  std::vector<Counts> Offsets;
  std::vector<char> IsPart;
};

#endif
