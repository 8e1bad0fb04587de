#ifndef MeshExtent_h
#define MeshExtent_h

#include <array>

class MeshCoordinates;
struct RasterView;

/// How large the box of a mesh is in the world, and where on the screen.
namespace MeshExtent
{
/// The longest diagonal, in world lengths.
double FindDiagonal(const MeshCoordinates& coordinates, const RasterView& view);

/// The least depth from the reference plane, and how deep the box is.
std::array<float, 2> FindDepths(const MeshCoordinates& coordinates, const RasterView& view);

/// x, y, width and height in pixels of the viewport.
std::array<int, 4> FindScreenBox(const MeshCoordinates& coordinates, const RasterView& view);
}

#endif
