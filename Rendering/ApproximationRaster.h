#ifndef ApproximationRaster_h
#define ApproximationRaster_h

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLVertexArrayObject.h"

#include <string>

class ApproximationTriangles;
struct RasterView;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class ApproximationRaster
 * @brief Raster engine for the triangles of an approximation: one draw call, in their order.
 */
class ApproximationRaster
{
public:
  /// Draws into the bound framebuffer. False, with the reason in GetFailure, where it cannot.
  bool Draw(vtkOpenGLRenderWindow* window, const RasterView& view,
    const ApproximationTriangles& triangles, bool isExponential);

  void ReleaseGraphicsResources();
  const std::string& GetFailure() const { return this->Failure; }

private:
  bool Upload(const ApproximationTriangles& triangles);
  bool BindVertices(vtkShaderProgram* program);

  vtkNew<vtkOpenGLBufferObject> Vertices;
  vtkNew<vtkOpenGLBufferObject> Indices;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  std::string Failure;
};

#endif
