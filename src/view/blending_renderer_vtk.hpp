#pragma once

#include <vtkOpenGLRenderer.h>

namespace fingerpad {

/// A renderer that lays what is translucent over the picture in the order of its actors, as it did before
/// VTK 9. VTK's own way finds the mean of all that lies over a pixel (vtkOrderIndependentTranslucentPass):
/// two pictures more of the whole view in floating point, which without a graphics card cost as much as all
/// else of a frame. So the order of drawing counts: a plane first, then the finger, of which only the sides
/// towards the camera are drawn, and last the patch of a contact, which is to be seen through it.
class BlendingRenderer : public vtkOpenGLRenderer {
 public:
  static BlendingRenderer* New();
  vtkTypeMacro(BlendingRenderer, vtkOpenGLRenderer);

  void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase*) override {
    this->UpdateTranslucentPolygonalGeometry();
  }
};

}  // namespace fingerpad
