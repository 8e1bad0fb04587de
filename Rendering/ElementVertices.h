#ifndef ElementVertices_h
#define ElementVertices_h

#include "EmptyVertexArray.h"
#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"

#include <vector>

class vtkShaderProgram;

/**
 * @class ElementVertices
 * @brief Draws elements as points, each with the five integers that ElementLists gives it.
 */
class ElementVertices
{
public:
  /// Uploads the list and draws it with the program that is ready. False where the driver has no
  /// room for it. The context must be current.
  bool Draw(const std::vector<int>& vertices, vtkShaderProgram* program);

  ///@{
  /// The same in parts: `count` elements from `first` on, by any program that is ready.
  bool Begin(const std::vector<int>& vertices);
  void DrawPart(int first, int count, vtkShaderProgram* program);
  void End();
  ///@}
  void ReleaseGraphicsResources();

private:
  vtkNew<vtkOpenGLBufferObject> Buffer;
  EmptyVertexArray VertexArray;
};

#endif
