#ifndef TetrahedraShaders_h
#define TetrahedraShaders_h

#include "DependentColors.h"

struct RasterView;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// How emission and absorption along a segment are found.
enum class SegmentIntegration
{
  Exact,
  Table,
  Average
};

/**
 * @class TetrahedraShaders
 * @brief The programs that draw tetrahedra as one point each.
 */
namespace TetrahedraShaders
{
/// What a program is for: all cells as they come, or of cyclic groups the next layer's depth or its
/// colour.
enum class Task
{
  Cells,
  LayerSearch,
  Layer
};

/// What a program draws with; what is off leaves no trace in its text.
struct Variant
{
  SegmentIntegration Integration = SegmentIntegration::Exact;
  bool IsLit = false;
  bool HasGradientOpacity = false;
  DependentColors::Kinds Colors = DependentColors::None;

  bool HasColors() const { return this->Colors != DependentColors::None; }
  bool IsShaded() const { return this->IsLit || this->HasGradientOpacity || this->HasColors(); }
};

/// Null where it does not compile. VTK's cache finds the compiled program by its source again.
vtkShaderProgram* ReadyProgram(
  vtkOpenGLRenderWindow* window, const RasterView& view, Task task, const Variant& variant);
}

#endif
