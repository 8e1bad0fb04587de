#ifndef ConvexCellShaders_h
#define ConvexCellShaders_h

struct RasterView;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * @class ConvexCellShaders
 * @brief The programs that draw convex cells as one point each.
 */
namespace ConvexCellShaders
{
/// What a mesh or a mapper does without costs nothing: it is not in the source.
struct Variant
{
  bool HasLongFaces = false;
  bool AverageEmission = false;
};

/// `main`: the fragment shader, with tags where it takes the shared parts. Null where it does not
/// compile. VTK's cache finds the compiled program by its source again.
vtkShaderProgram* ReadyProgram(
  vtkOpenGLRenderWindow* window, const char* main, const RasterView& view, const Variant& variant);
}

#endif
