#include "ElementVertices.h"

#include "ElementLists.h"
#include "VTKVersions.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

namespace
{
void SetAttribute(vtkShaderProgram* program, const char* name, int first, int count)
{
  const int location = glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), name);
  // A driver drops an attribute that the program does not use.
  if (location >= 0)
  {
    const size_t offset = sizeof(int) * static_cast<size_t>(first);
    glEnableVertexAttribArray(static_cast<GLuint>(location));
    glVertexAttribIPointer(static_cast<GLuint>(location), count, GL_INT,
      sizeof(int) * ElementLists::IntegersPerVertex, reinterpret_cast<const void*>(offset));
  }
}
}

//------------------------------------------------------------------------------
bool ElementVertices::Draw(const std::vector<int>& vertices, vtkShaderProgram* program)
{
  if (vertices.empty())
  {
    return true;
  }
  const bool good = this->Begin(vertices);
  if (good)
  {
    this->DrawPart(
      0, static_cast<int>(vertices.size()) / ElementLists::IntegersPerVertex, program);
  }
  this->End();
  return good;
}

//------------------------------------------------------------------------------
bool ElementVertices::Begin(const std::vector<int>& vertices)
{
  this->VertexArray.Bind();
  const bool good = this->Buffer->Upload(vertices, vtkOpenGLBufferObject::ArrayBuffer);
  if (good)
  {
    this->Buffer->Bind();
  }
  return good;
}

//------------------------------------------------------------------------------
void ElementVertices::DrawPart(int first, int count, vtkShaderProgram* program)
{
  SetAttribute(program, "corners", 0, 4);
  SetAttribute(program, "source", 4, 1);
  glDrawArrays(GL_POINTS, first, count);
}

//------------------------------------------------------------------------------
void ElementVertices::End()
{
  this->Buffer->Release();
  EmptyVertexArray::Release();
}

//------------------------------------------------------------------------------
void ElementVertices::ReleaseGraphicsResources()
{
  this->Buffer->ReleaseGraphicsResources();
  this->VertexArray.ReleaseGraphicsResources();
}
