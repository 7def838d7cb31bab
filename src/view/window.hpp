#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "view/view_input.hpp"
#include "view/view_state.hpp"

namespace fingerpad {

/// Something a person does at a window, for tests and demonstrations: handed to the same observers as what
/// the window system sends.
struct WindowEvent {
  enum class Kind { key, press, move, release, wheel_up, wheel_down, enter };
  double at_s = 0;  ///< since the window opened, at the earliest; slow frames delay it and all that follow
  Kind kind = Kind::key;
  std::string key = {};  ///< X key name, as "space" or "h"
  int x = 0, y = 0;      ///< mouse [px], from the lower left corner
};

/// What a window shows, told after each of its frames.
struct WindowReport {
  double t_s = 0;  ///< the moment shown
  ViewState state;
  long frames = 0;  ///< rendered so far
  double since_open_s = 0;
  Vec3 target_W = Vec3::Zero();         ///< touch windows: where the finger is wanted
  bool pressing = false;                ///< touch windows: against the surface
  double press_n = 0;                   ///< touch windows: the force aimed at
  double chart_from = 0, chart_to = 0;  ///< the range of x that the charts show
  double arrow_force_n = 0;             ///< the force of an arrow of full length
  bool invites = false;                 ///< touch windows: it says how to press
  Vec3 towards_eye_W = Vec3::UnitZ();   ///< from where it is looked
  double half_height_mm = 0;            ///< how much of the scene is seen
  std::string message;                  ///< what has just been told
  std::string hint;                     ///< touch windows: the title line
  std::string alarm;                    ///< touch windows: what stands in red
  std::string chart_tells;              ///< the value of the curve under the mouse; empty: none
};

struct WindowOptions {
  int width = 1280, height = 800;
  std::optional<LookFrom> look = {};  ///< the view at first; none: the usual
  std::vector<WindowEvent> events;    ///< in order of time
  std::function<void(const WindowReport&)> on_frame;
  /// A file was dropped onto the window. @returns why it cannot be shown; empty: the window closes for it
  std::function<std::string(const std::string& path)> on_drop = {};
  /// Where the window is taken away from outside, as by xkill, nothing can be drawn any more, and the program
  /// ends: this ends it. It must not return; see LostWindowWatch. None: X ends it.
  std::function<void()> on_loss;
};

/// Opens a window on a mesh, a scene or a trace and returns when it is closed (q, Escape, or by the window
/// manager). Space plays, the arrow keys step, the time line is dragged, `h` shows all keys.
///
/// Throws Error (usage) where there is no display.
void run_view_window(const ViewInput& input, const WindowOptions& options);

}  // namespace fingerpad
