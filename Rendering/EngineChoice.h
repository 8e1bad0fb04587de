#ifndef EngineChoice_h
#define EngineChoice_h

#include <string>

/// Which engine draws a frame.
namespace EngineChoice
{
/// `engine`: vtkConvexCellMapper's number; `obstacle`: what keeps Tiles from drawing what is set,
/// empty where nothing does. Automatic takes Tiles where OpenGL is drawn in software. Called in the
/// window's context.
bool UsesTiles(int engine, const std::string& obstacle);

/// Whether the current context's renderer is llvmpipe or softpipe.
bool IsSoftware();
}

#endif
