#pragma once

#include <vtkTooltipItem.h>

#include "view/drawing.hpp"

namespace fingerpad {

/// Where what a point's value is told stands: above the mouse and to its right, but whole within the window.
Box value_label_box(const Vec2& mouse_px, const Vec2& size_px, double window_width, double window_height);

/// The value of the point under the mouse, in a box as the other words over a picture. VTK's own may end
/// beyond the window's edge.
class ValueLabel : public vtkTooltipItem {
 public:
  static ValueLabel* New();
  vtkTypeMacro(ValueLabel, vtkTooltipItem);

  void set_em(double em) { em_ = em; }
  bool Paint(vtkContext2D* painter) override;

 private:
  double em_ = 12;
};

}  // namespace fingerpad
