#ifndef CellProjectionFrame_h
#define CellProjectionFrame_h

#include "FrameStatistics.h"
#include "RasterView.h"
#include "ViewRays.h"
#include "vtkOpenGLRenderWindow.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

class vtkRenderer;
class vtkTextureObject;
class vtkVolume;

/**
 * @class CellProjectionFrame
 * @brief What the stages of one frame hand on to each other.
 */
struct CellProjectionFrame
{
  vtkRenderer* Renderer = nullptr;
  vtkVolume* Volume = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  /// The viewport in pixels of the window's framebuffer.
  int Origin[2] = { 0, 0 };
  int Size[2] = { 0, 0 };
  /// The part of it that the mesh can reach, or all where the image is captured: x, y, width, height.
  std::array<int, 4> Box = { { 0, 0, 0, 0 } };
  /// The image that Tiles draw: fewer pixels than the viewport's where that is drawn coarsely.
  int ImageSize[2] = { 0, 0 };
  ViewRays Rays;
  /// View coordinates: normal and offset, the positive side stays.
  std::vector<glm::vec4> ClippingPlanes;
  vtkTextureObject* OpaqueDepth = nullptr;
  /// What the bound float target draws to.
  vtkTextureObject* Image = nullptr;
  /// Whether the Tiles engine draws, not Raster.
  bool UsesTiles = false;
  /// For Tiles: window depths of the image's pixels, row by row; null where nothing opaque is there.
  const float* OpaqueDepths = nullptr;
  /// For Tiles: asked by the thread that draws the frame while others are at its tiles; true where those are
  /// to be given up, because something opaque is there. Empty where there is nothing to ask.
  std::function<bool()> FindsOpaque;
  /// Whether the window's colours were read for what Tiles drew to be laid over.
  bool HoldsColors = false;
  /// What Tiles drew: premultiplied RGBA of the viewport's size, row by row; null where Raster draws.
  const float* Pixels = nullptr;
  FrameStatistics Statistics;

  /// The box with so many pixels more on each side, within the viewport.
  std::array<int, 4> GetWidenedBox(int by) const
  {
    std::array<int, 4> box = this->Box;
    for (int k = 0; k < 2; ++k)
    {
      box[k] = std::max(this->Box[k] - by, 0);
      box[k + 2] = std::min(this->Box[k] + this->Box[k + 2] + by, this->Size[k]) - box[k];
    }
    return box;
  }

  /// Makes the window current again where an observer may have drawn elsewhere. Unasked: under EGL every window says
  /// that it is current.
  void ReturnToWindow() const { this->Window->MakeCurrent(); }

  RasterView GetRasterView() const
  {
    return { &this->Rays, &this->ClippingPlanes, this->OpaqueDepth, this->Size[0], this->Size[1] };
  }
};

#endif
