#pragma once

#include <vtkOpenGLRenderer.h>

namespace fingerpad {

/// A renderer that lays what is translucent over the picture in the order of its actors, as it did before
/// VTK 9. VTK's own way finds the mean of all that lies over a pixel (vtkOrderIndependentTranslucentPass):
/// two pictures more of the whole view in floating point, which without a graphics card cost as much as all
/// else of a frame. Of a finger and a patch of one colour each the order does not matter.
class BlendingRenderer : public vtkOpenGLRenderer {
 public:
  static BlendingRenderer* New();
  vtkTypeMacro(BlendingRenderer, vtkOpenGLRenderer);

  void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase*) override {
    this->UpdateTranslucentPolygonalGeometry();
  }
};

}  // namespace fingerpad
