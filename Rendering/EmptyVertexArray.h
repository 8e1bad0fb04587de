#ifndef EmptyVertexArray_h
#define EmptyVertexArray_h

/**
 * @class EmptyVertexArray
 * @brief A vertex array object without attributes: a core profile draws from one only, though our
 * vertices are made by shaders.
 */
class EmptyVertexArray
{
public:
  /// The context must be current.
  void Bind();
  static void Release();
  void ReleaseGraphicsResources();

private:
  unsigned int Name = 0;
};

#endif
