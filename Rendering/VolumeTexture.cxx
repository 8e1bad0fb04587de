#include "VolumeTexture.h"

#include "MeshBlocks.h"
#include "PreparedVolume.h"
#include "VTKVersions.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

//------------------------------------------------------------------------------
void VolumeTexture::SetSource(vtkImageData* image, vtkDataArray* coordinates)
{
  if (this->Image != image || this->Coordinates != coordinates)
  {
    this->ImageUploaded = this->CoordinatesUploaded = vtkTimeStamp();
  }
  this->Image = image;
  this->Coordinates = coordinates;
}

//------------------------------------------------------------------------------
bool VolumeTexture::UploadImage(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared)
{
  unsigned int size[3];
  bool fits = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<unsigned int>(this->Image->GetDimensions()[axis]);
    fits = fits &&
           static_cast<int>(size[axis]) <= vtkTextureObject::GetMaximumTextureSize3D(window);
  }
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
  // An error that others left behind is not ours.
  glGetError();
  auto* values = const_cast<float*>(prepared.Scalars.Values.data());
  if (fits &&
      this->Texture->Create3DFromRaw(size[0], size[1], size[2], 1, VTK_FLOAT, values) &&
      glGetError() == GL_NO_ERROR)
  {
    this->ImageUploaded.Modified();
    return true;
  }
  this->Failure = "the driver has no room for a texture of " + std::to_string(size[0]) + " x " +
                  std::to_string(size[1]) + " x " + std::to_string(size[2]) + " floats";
  return false;
}

//------------------------------------------------------------------------------
void VolumeTexture::Append(vtkIdType point, std::vector<float>& coordinates) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    coordinates.push_back(static_cast<float>(this->Coordinates->GetComponent(point, axis)));
  }
  coordinates.push_back(0.0f);
}

//------------------------------------------------------------------------------
bool VolumeTexture::Send(
  vtkOpenGLRenderWindow* window, const std::vector<float>& coordinates)
{
  const bool good = this->CoordinateBuffer.Upload(window, coordinates, 4);
  this->Failure = good ? "" : this->CoordinateBuffer.GetFailure();
  return good;
}

//------------------------------------------------------------------------------
bool VolumeTexture::Upload(
  vtkOpenGLRenderWindow* window, const PreparedVolume& prepared, bool withCoordinates)
{
  if (this->ImageUploaded < prepared.ScalarsTime && !this->UploadImage(window, prepared))
  {
    return false;
  }
  if (!withCoordinates)
  {
    this->CoordinatesUploaded = vtkTimeStamp();
    return true;
  }
  if (this->CoordinatesUploaded < prepared.CellsTime ||
      this->CoordinatesUploaded < this->Coordinates->GetMTime())
  {
    std::vector<float> all;
    for (vtkIdType point = 0; point < this->Coordinates->GetNumberOfTuples(); ++point)
    {
      this->Append(point, all);
    }
    if (!this->Send(window, all))
    {
      return false;
    }
    this->CoordinatesUploaded.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
bool VolumeTexture::UploadBlock(vtkOpenGLRenderWindow* window, const MeshBlock& block)
{
  std::vector<float> some;
  for (const int id : block.PointIds)
  {
    this->Append(id, some);
  }
  return this->Send(window, some);
}

//------------------------------------------------------------------------------
void VolumeTexture::Activate(vtkShaderProgram* program)
{
  this->CoordinateBuffer.Activate(program, "textureCoordinates");
  this->Texture->Activate();
  program->SetUniformi("volumeTexture", this->Texture->GetTextureUnit());
}

//------------------------------------------------------------------------------
void VolumeTexture::Deactivate()
{
  this->CoordinateBuffer.Deactivate();
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
void VolumeTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->CoordinateBuffer.ReleaseGraphicsResources(window);
  this->Texture->ReleaseGraphicsResources(window);
  this->ImageUploaded = this->CoordinatesUploaded = vtkTimeStamp();
}
