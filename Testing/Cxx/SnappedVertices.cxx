#include "SnappedVertices.h"

#include "VTKVersions.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <cstdlib>
#include <string>

namespace
{
decltype(glShaderSource) original = nullptr;

// A statement that moves gl_Position, in clip coordinates.
std::string Snapping()
{
  GLint viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  const std::string cells =
    "vec2(" + std::to_string(128 * viewport[2]) + ", " + std::to_string(128 * viewport[3]) + ")";
  return "if (gl_Position.w > 0.0) { gl_Position.xy = floor(gl_Position.xy / gl_Position.w * " +
    cells + " + 0.5) / " + cells + " * gl_Position.w; }\n";
}

void Replace(std::string& text, const std::string& from, const std::string& to)
{
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
  }
}

void SnappedSource(
  GLuint shader, GLsizei count, const GLchar* const* parts, const GLint* lengths)
{
  std::string text;
  for (int i = 0; i < count; ++i)
  {
    text += lengths ? std::string(parts[i], lengths[i]) : std::string(parts[i]);
  }
  GLint type = 0;
  glGetShaderiv(shader, GL_SHADER_TYPE, &type);
  if (type == GL_GEOMETRY_SHADER)
  {
    Replace(text, "EmitVertex();", Snapping() + "EmitVertex();");
  }
  else if (type == GL_VERTEX_SHADER && text.find("gl_Position =") != std::string::npos)
  {
    Replace(text, "void main()", "void unsnapped()");
    text += "\nvoid main()\n{\nunsnapped();\n" + Snapping() + "}\n";
  }
  const char* snapped = text.c_str();
  original(shader, 1, &snapped, nullptr);
}

// Every new window loads the functions of OpenGL anew.
void Exchange(vtkObject*, unsigned long, void*, void*)
{
  if (glShaderSource != SnappedSource)
  {
    original = glShaderSource;
    glShaderSource = SnappedSource;
  }
}
}

//------------------------------------------------------------------------------
void SnappedVertices::TakeTestEnvironment(vtkRenderer* renderer)
{
  if (std::getenv("CELLPROJECTION_TEST_SNAP"))
  {
    vtkNew<vtkCallbackCommand> exchange;
    exchange->SetCallback(Exchange);
    renderer->AddObserver(vtkCommand::StartEvent, exchange);
  }
}
