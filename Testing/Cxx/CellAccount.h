#ifndef CellAccount_h
#define CellAccount_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkConvexCells;
class vtkUnstructuredGrid;

/// What vtkConvexCells makes of a mesh that has one cell of a type at most, held against what its
/// lists and coordinates say by themselves.
class CellAccount
{
public:
  /// `tolerance`: of curved cells.
  CellAccount(vtkUnstructuredGrid* grid, double tolerance);

  /// What is wrong; empty where nothing is. The second mode is compared with the first, too.
  std::string FindFault(bool tetrahedraOnly);

private:
  /// Of an input cell.
  struct Entry
  {
    int Type = 0;
    bool Listed = false;   // its ids are points, and as many as its type has
    bool Finite = false;   // and so are their coordinates
    bool HasSides = false; // Volume is known
    double Size = 0.0;     // largest coordinate less the smallest
    double Volume = 0.0;   // within its faces, of Size 1; negative where they are wound inward
    double FanVolume = 0.0; // the same by fans from the smallest ids
    bool RunsBack = false; // a face does on itself
    double Made[2] = { -1.0, -1.0 }; // by mode; below zero where it is not to be compared
  };

  void ReadCell(vtkIdType cell);
  void ReadSides(vtkIdType cell);
  std::string CheckEntry(Entry& entry, const std::string& why, double volume, bool tetrahedraOnly);
  std::string CheckReport(
    vtkConvexCells* filter, const std::vector<double>& volumes, bool tetrahedraOnly);
  std::string WeighPieces(vtkUnstructuredGrid* output, std::vector<double>& volumes) const;

  const double CurveTolerance;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::vector<vtkIdType> Canonical; // the smallest id at the same coordinates
  std::vector<Entry> Entries;       // by cell
};

#endif
