#include "EngineChoice.h"

#include "VTKVersions.h"
#include "vtkConvexCellMapper.h"

#include CELLPROJECTION_OPENGL_HEADER

namespace EngineChoice
{
//------------------------------------------------------------------------------
bool UsesTiles(int engine, const std::string& obstacle)
{
  if (engine == vtkConvexCellMapper::RASTER || !obstacle.empty())
  {
    return false;
  }
  return engine == vtkConvexCellMapper::TILES || IsSoftware();
}

//------------------------------------------------------------------------------
bool IsSoftware()
{
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = name ? name : "";
  return renderer.find("llvmpipe") != std::string::npos ||
         renderer.find("softpipe") != std::string::npos;
}
}
