#pragma once

#include <mutex>
#include <optional>

#include "view/input_event.hpp"
#include "view/key_table.hpp"
#include "view/pointed_scene.hpp"
#include "view/surface_hit.hpp"
#include "view/touch_target.hpp"
#include "view/touch_window.hpp"

namespace fingerpad {

/// The pointer and the keys of a live touch: which spot of a surface they mean, and whether it is pressed.
/// Nothing of it waits for a frame: the window says between its frames what it shows, and an event is
/// answered at once, by that. Any thread.
class PointerTouch {
 public:
  using FirstHit = std::function<std::optional<SurfaceHit>(const Vec3& from_mm, const Vec3& to_mm)>;

  /// @param input      kept by reference
  /// @param first_hit  called on the threads of events
  PointerTouch(const TouchWindowInput& input, TouchTarget target, FirstHit first_hit);

  /// @param t_s  of the frame that shows it, as of events
  void show(PointedScene shown, double t_s);
  bool take(const InputEvent& event);
  void change_force(int steps, double t_s);

  bool pressing() const;
  bool has_pressed() const;  ///< ever
  /// The button is held that was pressed beside the part: until it is let go the mouse is the view's.
  bool turns_view() const;
  double press_n() const;
  Vec3 pressed_W() const;
  /// Whether a finger that is there cannot reach what is under the pointer, since it is too large.
  bool is_kept_from_spot(const Vec3& finger_W) const;

 private:
  bool take_key(KeyAction action, double t_s);
  bool follows_view() const;
  bool point_at(double x_px, double y_px);
  void press();
  void tell(double t_s);
  bool is_on_panel(double x_px, double y_px) const;

  const TouchWindowInput& input_;
  FirstHit first_hit_;
  mutable std::mutex mutex_;  // of all below
  PointedScene shown_;
  TouchTarget target_;
  bool held_ = false, over_ = false, latched_ = false, has_pressed_ = false;
  bool turns_view_ = false;
  bool on_panel_ = false, beside_panels_ = false;  ///< where the button is held that was pressed there
  double told_s_ = 0;
  bool led_by_keys_ = true;      ///< since the pointer moved last, or ever
  bool is_turned_ = false;       ///< the view, since what lies under the pointer was last looked for
  Vec2 last_px_ = Vec2::Zero();  ///< where the pointer was
};

/// Which rows of key_table() hold in the window of a touch.
unsigned touch_window_kind(const TouchWindowInput& input);

}  // namespace fingerpad
