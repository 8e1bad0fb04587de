#ifndef ElementShaders_h
#define ElementShaders_h

#include <string>

struct RasterView;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * @class ElementShaders
 * @brief The barycentric stages that all programs of elements share: assembly, construction, and
 * what a fragment knows of its element.
 */
namespace ElementShaders
{
/// `fragment` with what its tags Element, Scalar, Passage, Crossing, TransferFunction, Integral and Segment
/// stand for. `isTextured`: scalars are those of a VolumeTexture.
std::string WithElement(const std::string& fragment, bool isTextured = false);

/// A program of `fragment`, which WithElement has seen; null where it does not compile. `withIds`
/// hands on the ids of the corners. VTK's cache finds the compiled program by its source again.
vtkShaderProgram* ReadyProgram(vtkOpenGLRenderWindow* window, const RasterView& view,
  const std::string& fragment, bool withIds);
}

#endif
