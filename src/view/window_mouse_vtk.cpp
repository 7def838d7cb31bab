#include "view/window_mouse_vtk.hpp"

#include <vtkCommand.h>

#include <utility>

namespace fingerpad {

WindowMouse::Outcome WindowMouse::take(unsigned long event, int x, int y, bool taken) {
  if (on_page(event) || on_panels(event, x, y)) return {true, true};
  ChartBoard& charts = stage_.charts();
  bool moved_on_charts = false;
  switch (event) {
    case vtkCommand::LeftButtonPressEvent:
      // All of a chart that is not zoomed is in sight: there is nowhere to move it.
      taken |= charts.zoomed() && charts.press(x, y);
      taken = (handlers_.press && handlers_.press(x, y)) || taken;
      break;
    case vtkCommand::EnterEvent:  // a window that opens under the pointer is told of it so, and of no move
    case vtkCommand::MouseMoveEvent:
      moved_on_charts = charts.move(x, y);
      taken = (handlers_.move && handlers_.move(x, y)) || taken;
      break;
    case vtkCommand::LeftButtonReleaseEvent:
      taken |= charts.release(x, y);
      taken = (handlers_.release && handlers_.release()) || taken;
      break;
    case vtkCommand::MouseWheelForwardEvent:
    case vtkCommand::MouseWheelBackwardEvent:
      taken = wheel(x, y, event == vtkCommand::MouseWheelForwardEvent ? 1 : -1);
      break;
    default:
      break;
  }
  return {taken, taken || moved_on_charts};
}

/// It never turns the camera.
bool WindowMouse::wheel(int x, int y, int steps) {
  ChartBoard& charts = stage_.charts();
  // All over the charts' column the wheel is theirs: beside a panel it does nothing.
  const bool on_charts = charts.visible() && stage_.layout().charts.holds(x, y);
  const bool theirs = charts.wheel(x, y, steps) || on_charts || (handlers_.wheel && handlers_.wheel(steps));
  if (!theirs) stage_.zoom(steps > 0 ? 1.15 : 1 / 1.15);
  return true;
}

void WindowMouse::on_panel(const PanelHit& hit) {
  if (!parts_.owns(hit)) {
    if (handlers_.panel) handlers_.panel(hit);
    return;
  }
  parts_.click(hit);
}

/// While the help page is open the mouse does nothing but close it, by a press anywhere. A button that is
/// held since before is let go as ever.
bool WindowMouse::on_page(unsigned long event) {
  bool& open = stage_.state().help;
  if (event == vtkCommand::LeftButtonReleaseEvent) return std::exchange(closed_page_, false);
  if (event == vtkCommand::LeftButtonPressEvent) return closed_page_ = std::exchange(open, false);
  return open || closed_page_;
}

/// What the mouse does on a panel goes no further; a button pressed beside it is not its.
bool WindowMouse::on_panels(unsigned long event, int x, int y) {
  const auto hit = stage_.panels().hit(stage_.panel_layout(), x, y);
  switch (event) {
    case vtkCommand::LeftButtonPressEvent:
      on_panel_ = hit.has_value();
      beside_panels_ = !on_panel_;
      if (hit) on_panel(*hit);
      return on_panel_;
    case vtkCommand::LeftButtonReleaseEvent:
      beside_panels_ = false;
      return std::exchange(on_panel_, false);
    case vtkCommand::EnterEvent:
    case vtkCommand::MouseMoveEvent:
      return on_panel_ || (hit && !beside_panels_);
    default:
      break;
  }
  if (!hit) return false;
  if (!parts_.owns(*hit)) {
    PanelHit turned = *hit;
    turned.steps = event == vtkCommand::MouseWheelForwardEvent ? 1 : -1;
    on_panel(turned);
  }
  return true;
}

}  // namespace fingerpad
