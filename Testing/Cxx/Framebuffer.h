#ifndef Framebuffer_h
#define Framebuffer_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkType.h"

#include <vector>

class vtkOpenGLState;

/// A framebuffer of our own making, bound for drawing and reading while it lives; no mask, no test.
class Framebuffer
{
public:
  static constexpr int Size = 64;

  struct Kind
  {
    const char* Name = "";
    bool HasTextures = true; // else renderbuffers
    int ColorType = VTK_UNSIGNED_CHAR;
    int Colors = 1; // how many are drawn to
    int DepthBits = 24; // 0 for none
    int Samples = 0;
    bool HasStencil = false;
  };

  Framebuffer(vtkRenderWindow* window, const Kind& kind);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  void operator=(const Framebuffer&) = delete;

  /// All of it, in one colour and one depth.
  void Clear(const float (&color)[4], double depth);
  /// The same of a part alone: x, y, width and height.
  void ClearPart(const int (&part)[4], const float (&color)[4], double depth);
  /// RGBA of all pixels, row by row, of a framebuffer of bytes and one sample.
  std::vector<unsigned char> ReadColors();

  vtkOpenGLRenderWindow* Window;
  vtkOpenGLState* State;
  bool IsComplete = false;

private:
  vtkNew<vtkOpenGLFramebufferObject> Object;
};

#endif
