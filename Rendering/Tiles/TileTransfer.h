/**
 * The transfer function as the tiles read it: per piece between two nodes the slope and the offset
 * of red, green, blue and extinction over the normalised scalar. Nodes on a line make one piece.
 */
#ifndef TileTransfer_h
#define TileTransfer_h

#include <array>
#include <cstddef>
#include <vector>

class TransferFunction;

class TileTransfer
{
public:
  /** `longest`: the greatest length of a ray in the mesh; extinction beyond opaque is cut off. */
  void Build(const TransferFunction& function, double longest);

  int NumberOfPieces = 0;
  /** Steps of a binary search over all pieces. */
  int SearchSteps = 0;
  float GreatestExtinction = 0.0f;

  /** Piece i covers Bounds[i] to Bounds[i + 1]; beyond the last one there is 3e38. All arrays are
   *  padded, so that a whole vector can be read from their start. */
  std::vector<float> Bounds;
  std::vector<float> Slopes[4];
  std::vector<float> Offsets[4];
  /** The same of a piece side by side, of extinction half the slope. */
  struct Line
  {
    float Low, High, HalfSlope, Offset;
    float ColorSlopes[3], ColorOffsets[3];
  };
  std::vector<Line> Lines;
  /** Nothing is seen from a scalar of piece i up to SeenFrom[i], and down to SeenTo[i]; where the
   *  piece itself is seen -1e30 and 1e30. */
  std::vector<float> SeenFrom, SeenTo;
  /** Whether there is any such piece. */
  bool HasTransparent = false;

  /** No vector is longer. */
  static constexpr std::size_t Padding = 64;

private:
  struct Node
  {
    double Position = 0.0;
    std::array<double, 4> Values;
  };
  void Allocate(std::size_t nodes);
  /** The piece between two nodes, unless the last one goes on that far. */
  void Append(const Node& first, const Node& last);
  bool Continues(const Node& first, const Node& last) const;
  void FindSeen();
  void FillLines();

  // The line of the last piece.
  Node LastStart;
  std::array<double, 4> LastSlopes;
};

#endif
