#pragma once

#include <functional>

#include "view/input_event.hpp"
#include "view/key_table.hpp"
#include "view/side_panels.hpp"
#include "view/window.hpp"

namespace fingerpad {

/// What a window's own keys and mouse do; true means that the event went no further. What they leave turns
/// the camera.
struct WindowHandlers {
  unsigned window = windows::still;  ///< which rows of key_table() hold
  AtOnce at_once;                    ///< what waits for no frame, before all others; may be none
  /// Once, after the first frame: the threads that draw are there. May be none.
  std::function<void()> has_opened;
  std::function<bool(KeyAction action)> act;
  std::function<bool(int x, int y)> press, move;
  std::function<bool()> release;
  std::function<bool(int steps)> wheel;
  /// A click (steps 0) or steps on a row of a panel that is not the loop's own.
  std::function<void(const PanelHit& hit)> panel;
  /// Once a frame. @returns whether anything is new to see
  std::function<bool(double elapsed_s)> frame;
  std::function<void(WindowReport&)> report;
};

}  // namespace fingerpad
