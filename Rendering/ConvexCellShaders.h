#ifndef ConvexCellShaders_h
#define ConvexCellShaders_h

#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * @class ConvexCellShaders
 * @brief The programs that draw convex cells as one point each.
 */
namespace ConvexCellShaders
{
/// `main`: the fragment shader, with tags where it takes the shared parts.
std::string FragmentSource(const char* main);

/// Null where it does not compile. VTK's cache finds the compiled program by its source again.
vtkShaderProgram* ReadyProgram(vtkOpenGLRenderWindow* window, const std::string& fragment);
}

#endif
