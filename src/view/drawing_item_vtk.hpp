#pragma once

#include <vtkContextItem.h>
#include <vtkObjectFactory.h>

#include <memory>
#include <vector>

#include "view/drawing.hpp"

namespace fingerpad {

/// Paints a drawing with a painter of VTK, whose units must be pixels: on a screen, or into the drawing that
/// it records (drawing_device_vtk.hpp).
/// @param width, height  of the viewport [px]
void paint(const Drawing& drawing, vtkContext2D* painter, int width, int height);

/// Paints drawings over a renderer, one over the other.
class DrawingItem : public vtkContextItem {
 public:
  static DrawingItem* New();
  vtkTypeMacro(DrawingItem, vtkContextItem);

  void show(std::vector<std::shared_ptr<const Drawing>> drawings);
  /// Of a page that is painted in strips: the strip from `bottom_px` up, of a page of this height. Without it
  /// the scene is the page.
  void show_strip(int bottom_px, int page_height_px);
  bool Paint(vtkContext2D* painter) override;

 private:
  std::vector<std::shared_ptr<const Drawing>> drawings_;
  int strip_bottom_px_ = 0, page_height_px_ = 0;
};

}  // namespace fingerpad
