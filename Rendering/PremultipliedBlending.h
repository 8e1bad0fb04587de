#ifndef PremultipliedBlending_h
#define PremultipliedBlending_h

#include "VTKVersions.h"
#include "vtkOpenGLState.h"

#include CELLPROJECTION_OPENGL_HEADER

/**
 * @class PremultipliedBlending
 * @brief GL state for laying premultiplied colours over each other, restored at the end of its
 * life.
 */
class PremultipliedBlending
{
public:
  explicit PremultipliedBlending(vtkOpenGLState* state)
    : Viewport(state)
    , Scissor(state)
    , ClearColor(state)
    , DepthMask(state)
    , Function(state)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
    , CullFace(state, GL_CULL_FACE)
  {
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  PremultipliedBlending(const PremultipliedBlending&) = delete;
  void operator=(const PremultipliedBlending&) = delete;

private:
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglClearColor ClearColor;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglBlendFuncSeparate Function;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
};

#endif
