#ifndef EnclosureCheck_h
#define EnclosureCheck_h

#include <string>

class TestChecks;
class vtkConvexifyFilter;

/// Whether the cells that fill a mesh to its hull or its box are convex, all volumes add up, and no point moves.
namespace EnclosureCheck
{
/// `filter`: updated, with DiscardOutsideHull off. Volumes to 1e-9 of the enclosure's; corners may
/// stand out of a face's plane by `largestDent` of the diagonal.
void TestFilled(TestChecks& checks, const std::string& name, vtkConvexifyFilter* filter,
  double largestDent = 1e-9);
}

#endif
