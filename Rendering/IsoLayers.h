#ifndef IsoLayers_h
#define IsoLayers_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;
class vtkWindow;

/**
 * @class IsoLayers
 * @brief Colour and depth of iso-surfaces, layer after layer from front to back; the first layer is
 * kept.
 */
class IsoLayers
{
public:
  /// Makes the layers in this size. False where the driver cannot render to them.
  bool Prepare(vtkOpenGLRenderWindow* window, int width, int height);

  /// Between these, what is drawn goes to the next layer, nearest first; what passes is counted.
  /// Depth test and mask are the caller's to restore.
  void BeginLayer(vtkOpenGLRenderWindow* window, bool isFirst);
  void EndLayer(vtkOpenGLRenderWindow* window);
  /// Whether the last layer has anything; waits for it.
  bool WasAnyDrawn() const;

  vtkTextureObject* GetColor() { return this->Layers[this->Newest].Color; }
  vtkTextureObject* GetDepth() { return this->Layers[this->Newest].Depth; }
  /// Of the layer before.
  vtkTextureObject* GetLastDepth() { return this->Layers[this->Last].Depth; }
  vtkTextureObject* GetFirstColor() { return this->Layers[0].Color; }
  vtkTextureObject* GetFirstDepth() { return this->Layers[0].Depth; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Layer
  {
    vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
    vtkNew<vtkTextureObject> Color;
    vtkNew<vtkTextureObject> Depth;
  };
  static bool MakeLayer(vtkOpenGLRenderWindow* window, Layer& layer, int width, int height);

  Layer Layers[3];
  int Newest = 0;
  int Last = 1;
  unsigned int Query = 0;
};

#endif
