#include "ElementProjection.h"

#include "ElementBuffers.h"
#include "ElementShaders.h"
#include "RayUniforms.h"
#include "cpElementProjection.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
bool ElementProjection::Draw(vtkOpenGLRenderWindow* window, const RasterView& view,
  const std::vector<int>& vertices, ElementBuffers& buffers)
{
  const bool isTextured = buffers.GetTexture().IsUsed();
  const std::string source = ElementShaders::WithElement(cpElementProjection, isTextured);
  vtkShaderProgram* program = ElementShaders::ReadyProgram(window, view, source, isTextured);
  if (!program)
  {
    this->Failure = "the projection's shaders did not compile";
    return false;
  }
  view.OpaqueDepth->Activate();
  RayUniforms::Set(program, view);
  buffers.Activate(program);
  const bool drawn = this->Vertices.Draw(vertices, program);
  buffers.Deactivate();
  view.OpaqueDepth->Deactivate();
  this->Failure = drawn ? "" : "the driver has no room for the elements";
  return drawn;
}
