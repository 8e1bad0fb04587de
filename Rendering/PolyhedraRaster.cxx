#include "PolyhedraRaster.h"

#include "ConvexCellBuffers.h"
#include "ConvexCellShaders.h"
#include "RasterView.h"
#include "RayUniforms.h"
#include "VTKVersions.h"
#include "cpPolyhedraFragment.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include CELLPROJECTION_OPENGL_HEADER

//------------------------------------------------------------------------------
bool PolyhedraRaster::Draw(vtkOpenGLRenderWindow* window, const RasterView& view,
  ConvexCellBuffers& buffers, bool averageEmission)
{
  static const std::string fragment = ConvexCellShaders::FragmentSource(cpPolyhedraFragment);
  vtkShaderProgram* program = ConvexCellShaders::ReadyProgram(window, fragment);
  if (!program)
  {
    this->Failure = "the projection's shaders did not compile";
    return false;
  }
  view.OpaqueDepth->Activate();
  RayUniforms::Set(program, view);
  program->SetUniformi("averageEmission", averageEmission ? 1 : 0);
  buffers.Activate(program);
  window->GetState()->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  this->Cells.Draw();
  buffers.Deactivate();
  view.OpaqueDepth->Deactivate();
  return true;
}
