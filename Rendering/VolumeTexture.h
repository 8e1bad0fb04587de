#ifndef VolumeTexture_h
#define VolumeTexture_h

#include "TextureBuffer.h"
#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkShaderProgram;
struct MeshBlock;
struct PreparedVolume;

/**
 * @class VolumeTexture
 * @brief An image that is bound to a mesh by texture coordinates at its points, on the GPU.
 *
 * Coordinates 0 and 1 are the first and the last points of the image along each axis; the image is
 * linear between its points and goes on with its rim outside.
 */
class VolumeTexture
{
public:
  /// Null where there is none. Both must outlive what is drawn.
  void SetSource(vtkImageData* image, vtkDataArray* coordinates);
  bool IsUsed() const { return this->Image != nullptr; }

  /// The image, whose normalised values are the volume's scalars, and with `coordinates` those of
  /// all points, where they changed. False, with the reason in GetFailure, where there is no room.
  bool Upload(
    vtkOpenGLRenderWindow* window, const PreparedVolume& prepared, bool withCoordinates);
  bool UploadBlock(vtkOpenGLRenderWindow* window, const MeshBlock& block);

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetFailure() const { return this->Failure; }

private:
  bool UploadImage(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared);
  bool Send(vtkOpenGLRenderWindow* window, const std::vector<float>& coordinates);
  void Append(vtkIdType point, std::vector<float>& coordinates) const;

  vtkImageData* Image = nullptr;
  vtkDataArray* Coordinates = nullptr;
  TextureBuffer CoordinateBuffer;
  vtkNew<vtkTextureObject> Texture;
  vtkTimeStamp ImageUploaded;
  vtkTimeStamp CoordinatesUploaded;
  std::string Failure;
};

#endif
