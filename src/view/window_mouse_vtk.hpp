#pragma once

#include "view/parts_panel_vtk.hpp"
#include "view/stage_vtk.hpp"
#include "view/window_handlers.hpp"

namespace fingerpad {

/// Whose an event of the mouse is: the help page's, a panel's, a chart's, the window's own, or the camera's.
class WindowMouse {
 public:
  /// All are kept by reference.
  WindowMouse(Stage& stage, const WindowHandlers& handlers, PartsPanel& parts)
      : stage_(stage), handlers_(handlers), parts_(parts) {}

  struct Outcome {
    bool taken = false;  ///< it goes no further: what is left turns the camera
    bool new_to_see = false;
  };
  /// @param event  vtkCommand's
  /// @param taken  by what answers at once
  Outcome take(unsigned long event, int x, int y, bool taken);

 private:
  bool on_page(unsigned long event);
  bool on_panels(unsigned long event, int x, int y);
  void on_panel(const PanelHit& hit);
  bool wheel(int x, int y, int steps);

  Stage& stage_;
  const WindowHandlers& handlers_;
  PartsPanel& parts_;
  bool on_panel_ = false, beside_panels_ = false;  ///< where the button is held that was pressed there
  bool closed_page_ = false;                       ///< by the button that is held
};

}  // namespace fingerpad
