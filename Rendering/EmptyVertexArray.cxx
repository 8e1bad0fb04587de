#include "EmptyVertexArray.h"

#include "VTKVersions.h"

#include CELLPROJECTION_OPENGL_HEADER

//------------------------------------------------------------------------------
void EmptyVertexArray::Bind()
{
  if (this->Name == 0)
  {
    glGenVertexArrays(1, &this->Name);
  }
  glBindVertexArray(this->Name);
}

//------------------------------------------------------------------------------
void EmptyVertexArray::Release()
{
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
void EmptyVertexArray::ReleaseGraphicsResources()
{
  if (this->Name != 0)
  {
    glDeleteVertexArrays(1, &this->Name);
    this->Name = 0;
  }
}
