#ifndef SnappedVertices_h
#define SnappedVertices_h

class vtkRenderer;

/// What a GPU does to vertices, on software OpenGL: they move to a grid of 1/256 pixel, and what is
/// interpolated is so between those. Software moves them for coverage alone.
namespace SnappedVertices
{
/// From now on, in every shader of every window, where CELLPROJECTION_TEST_SNAP is set. The grid is
/// that of the viewport in which a shader is compiled.
void TakeTestEnvironment(vtkRenderer* renderer);
}

#endif
