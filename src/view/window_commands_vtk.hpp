#pragma once

#include <functional>
#include <string>
#include <utility>

#include "view/key_table.hpp"
#include "view/parts_panel_vtk.hpp"
#include "view/place_marks.hpp"
#include "view/stage_vtk.hpp"

namespace fingerpad {

/// What keys do in every window, whatever it shows: how it is looked at, what of it is drawn, marks,
/// screenshots, and its end.
class WindowCommands {
 public:
  /// What they ask of the window.
  struct Window {
    std::function<void()> close;
    std::function<void(const std::string& words)> tell;
    std::function<std::pair<int, int>()> mouse_px;  ///< where it is
  };

  /// @param stage, parts  kept by reference
  WindowCommands(Stage& stage, PartsPanel& parts, Window window);

  /// @returns whether there is such a command
  bool act(KeyAction action);

 private:
  bool look(KeyAction action);
  void leave();
  void mark();
  void take_screenshot();

  Stage& stage_;
  PartsPanel& parts_;
  Window window_;
  PlaceMarks marks_;
};

}  // namespace fingerpad
