#ifndef NumberedPoints_h
#define NumberedPoints_h

#include "EmptyVertexArray.h"
#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"

#include <vector>

/**
 * @class NumberedPoints
 * @brief A list of cells, or of other things with a number, on the GPU: each is drawn as a point.
 */
class NumberedPoints
{
public:
  bool Upload(const std::vector<unsigned int>& list);
  /// With the program that is ready.
  void Draw();
  void ReleaseGraphicsResources();

private:
  vtkNew<vtkOpenGLBufferObject> Elements;
  EmptyVertexArray VertexArray;
  int Count = 0;
};

#endif
