#ifndef ShellShaders_h
#define ShellShaders_h

#include <string>

struct RasterView;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * @class ShellShaders
 * @brief The programs of the barycentric stages: elements into the slices of a shell, and the
 * blending stage's.
 */
namespace ShellShaders
{
struct Variant
{
  bool IsPreIntegrated = false;
  bool IsTextured = false;
  int NumberOfTargets = 1;

  bool operator==(const Variant& other) const
  {
    return this->IsPreIntegrated == other.IsPreIntegrated &&
           this->IsTextured == other.IsTextured &&
           this->NumberOfTargets == other.NumberOfTargets;
  }
};

/// Draws elements into a shell. Null where it does not compile. VTK's cache finds the compiled
/// program by its source again.
vtkShaderProgram* ReadyElements(
  vtkOpenGLRenderWindow* window, const RasterView& view, const Variant& variant);

/// Classifies and composites a shell, drawn over the whole viewport.
std::string BlendSource(const Variant& variant);

/// Counts the pixels that are not opaque, drawn over the whole viewport.
const std::string& OpenSource();
}

#endif
