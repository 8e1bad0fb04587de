#include "NumberedPoints.h"

#include "VTKVersions.h"

#include CELLPROJECTION_OPENGL_HEADER

//------------------------------------------------------------------------------
bool NumberedPoints::Upload(const std::vector<unsigned int>& list)
{
  this->Count = static_cast<int>(list.size());
  return list.empty() || this->Elements->Upload(list, vtkOpenGLBufferObject::ElementArrayBuffer);
}

//------------------------------------------------------------------------------
void NumberedPoints::Draw()
{
  if (this->Count == 0)
  {
    return;
  }
  this->VertexArray.Bind();
  this->Elements->Bind();
  glDrawElements(GL_POINTS, this->Count, GL_UNSIGNED_INT, nullptr);
  this->Elements->Release();
  EmptyVertexArray::Release();
}

//------------------------------------------------------------------------------
void NumberedPoints::ReleaseGraphicsResources()
{
  this->Elements->ReleaseGraphicsResources();
  this->VertexArray.ReleaseGraphicsResources();
}
