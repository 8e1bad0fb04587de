#ifndef RasterView_h
#define RasterView_h

#include <glm/vec4.hpp>

#include <vector>

class ViewRays;
class vtkTextureObject;

/**
 * @class RasterView
 * @brief What a Raster engine draws through: the rays and where the scene ends them.
 */
struct RasterView
{
  const ViewRays* Rays = nullptr;
  const std::vector<glm::vec4>* ClippingPlanes = nullptr;
  vtkTextureObject* OpaqueDepth = nullptr;
  int Width = 0;
  int Height = 0;
};

#endif
