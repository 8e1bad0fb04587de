#ifndef IsoTriangleRaster_h
#define IsoTriangleRaster_h

#include "EmptyVertexArray.h"
#include "RasterView.h"
#include "TextureBuffer.h"
#include "vtkTimeStamp.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

class IsoTriangles;
class ShadingBuffers;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class IsoTriangleRaster
 * @brief Draws opaque iso-surfaces from their triangles, lit at every pixel, in any order: the
 * depth test is the caller's.
 */
class IsoTriangleRaster
{
public:
  /// The surfaces, and when their triangles, vertices and gradients were made last.
  struct Source
  {
    const IsoTriangles* Triangles = nullptr;
    vtkTimeStamp CutTime;
    vtkTimeStamp VerticesTime;
    vtkTimeStamp GradientsTime;
    /// Of each surface.
    std::vector<glm::vec3> Colors;
  };

  /// Uploads what is new and compiles. False, with the reason in GetFailure, where it cannot.
  bool Prepare(vtkOpenGLRenderWindow* window, const RasterView& view, const Source& source,
    const ShadingBuffers& shading);

  /// `fragmentDepth`: a fragment at depth d from the reference plane writes (x + y d) / (z + w d).
  void Draw(vtkOpenGLRenderWindow* window, const RasterView& view, const Source& source,
    ShadingBuffers& shading, const glm::vec4& fragmentDepth);

  size_t GetNumberOfBytes() const { return this->NumberOfBytes; }
  /// Of the last Prepare, and how long that took.
  size_t GetUploadedBytes() const { return this->UploadedBytes; }
  double GetUploadSeconds() const { return this->UploadSeconds; }
  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetFailure() const { return this->Failure; }

private:
  bool Upload(vtkOpenGLRenderWindow* window, const Source& source, bool isLit);
  bool SendTriangles(vtkOpenGLRenderWindow* window, const IsoTriangles& triangles);
  bool Send(vtkOpenGLRenderWindow* window, TextureBuffer& buffer, const std::vector<float>& values,
    vtkTimeStamp& uploaded);

  TextureBuffer Vertices;
  TextureBuffer Gradients;
  TextureBuffer Corners;
  vtkNew<vtkOpenGLBufferObject> Indices;
  vtkTimeStamp TrianglesUploaded;
  vtkTimeStamp VerticesUploaded;
  vtkTimeStamp GradientsUploaded;
  EmptyVertexArray VertexArray;
  vtkShaderProgram* Program = nullptr;
  size_t TriangleBytes = 0;
  size_t NumberOfBytes = 0;
  size_t UploadedBytes = 0;
  double UploadSeconds = 0.0;
  std::string Failure;
};

#endif
