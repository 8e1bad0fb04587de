#ifndef ElementBuffers_h
#define ElementBuffers_h

#include "TextureBuffer.h"
#include "VolumeTexture.h"
#include "vtkTimeStamp.h"

#include <string>

struct MeshBlock;
struct PreparedVolume;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class ElementBuffers
 * @brief What elements share on the GPU: the points, one scalar per point or cell, the transfer
 * function. Nothing is kept there per element.
 */
class ElementBuffers
{
public:
  /// What has changed since the last call. False, with the reason in GetFailure, where the driver
  /// has no room.
  bool Upload(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared);

  /// The same but for points and scalars: a block's follow, one after the other.
  bool UploadWithoutMesh(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared);
  bool UploadBlock(
    vtkOpenGLRenderWindow* window, const PreparedVolume& prepared, const MeshBlock& block);

  /// Where it is used, scalars are the texture's and points have none.
  VolumeTexture& GetTexture() { return this->Texture; }

  /// Binds all of it for a program that is ready.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  /// Of points and scalars, the transfer function's few aside.
  size_t GetNumberOfBytes() const { return this->NumberOfBytes; }
  /// Of these, what the last call of Upload sent, and how long that took.
  size_t GetUploadedBytes() const { return this->UploadedBytes; }
  double GetUploadSeconds() const { return this->UploadSeconds; }
  const std::string& GetFailure() const { return this->Failure; }

private:
  bool Check(const TextureBuffer& buffer, bool uploaded);
  bool UploadMesh(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared);
  bool Send(vtkOpenGLRenderWindow* window, TextureBuffer& buffer, const std::vector<float>& values,
    int components);
  bool BeginUpload(
    vtkOpenGLRenderWindow* window, const PreparedVolume& prepared, bool withMesh);
  bool UploadFunction(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared);

  TextureBuffer Points;
  TextureBuffer Scalars;
  VolumeTexture Texture;
  TextureBuffer NodePositions;
  TextureBuffer NodeValues;
  vtkTimeStamp PointsUploaded;
  vtkTimeStamp ScalarsUploaded;
  vtkTimeStamp FunctionUploaded;
  size_t NumberOfBytes = 0;
  size_t UploadedBytes = 0;
  double UploadSeconds = 0.0;
  int NumberOfNodes = 0;
  bool OnePerCell = false;
  std::string Failure;
};

#endif
