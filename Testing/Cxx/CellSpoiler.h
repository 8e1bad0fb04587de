#ifndef CellSpoiler_h
#define CellSpoiler_h

#include "ConvexCellsTesting.h"

#include <random>

/// Makes random cells, one of three as good as new, and spoils the others once or twice. Every other
/// polyhedron has nodes on its edges.
class CellSpoiler
{
public:
  /// A cell with points of its own.
  struct Cell
  {
    int Type = VTK_TETRA;
    std::vector<ConvexCellsTesting::Point> Points;
    std::vector<vtkIdType> Corners;
    ConvexCellsTesting::Faces Sides; // of a polyhedron
  };

  explicit CellSpoiler(unsigned int seed)
    : Random(seed)
  {
  }

  Cell Make(int type);

private:
  double Number(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  std::size_t Index(std::size_t count) { return this->Random() % count; }

  Cell MakePolyhedron();
  using Edge = std::array<vtkIdType, 2>;
  std::vector<vtkIdType> HangNodes(Cell& cell, const Edge& edge, std::size_t rarity);
  void Hang(Cell& cell);
  void Renumber(Cell& cell);
  void Place(Cell& cell);
  void SpoilPoints(Cell& cell);
  void SpoilShape(Cell& cell);
  void SpoilLists(Cell& cell);
  void SpoilSides(Cell& cell);

  std::mt19937 Random;
};

#endif
