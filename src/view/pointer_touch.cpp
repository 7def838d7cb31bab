#include "view/pointer_touch.hpp"

#include <algorithm>
#include <utility>

namespace fingerpad {

unsigned touch_window_kind(const TouchWindowInput& input) {
  const unsigned leader = input.pointer_leads ? windows::led : windows::watched;
  return windows::touch | leader | (input.set_stop ? windows::motors : 0);
}

PointerTouch::PointerTouch(const TouchWindowInput& input, TouchTarget target, FirstHit first_hit)
    : input_(input), first_hit_(std::move(first_hit)), target_(std::move(target)) {}

void PointerTouch::show(PointedScene shown, double t_s) {
  const std::lock_guard lock(mutex_);
  const PointedScene before = std::exchange(shown_, std::move(shown));
  const SightLines &then = before.lines, &now = shown_.lines;
  is_turned_ |= then.near_mm != now.near_mm || then.far_mm != now.far_mm || then.right_mm != now.right_mm ||
                then.up_mm != now.up_mm;
  const bool resized = before.scene.width != shown_.scene.width || before.scene.height != shown_.scene.height;
  // X told where the pointer is in the new window before there was a frame of it: it was looked for in the
  // old one, and missed the part.
  const bool missed = resized && held_ && !over_;
  if (!missed && !follows_view()) return;
  over_ = point_at(last_px_.x(), last_px_.y());
  if (!over_) return;
  press();
  tell(t_s);
}

/// Whether something else may lie under a pointer that rests, since a key has turned the view or the window
/// has another size. A finger that presses stays until it is let go, and one that keys have led.
bool PointerTouch::follows_view() const {
  const bool is_busy = held_ || latched_ || turns_view_ || on_panel_ || led_by_keys_;
  return is_turned_ && !is_busy && !is_on_panel(last_px_.x(), last_px_.y());
}

bool PointerTouch::is_on_panel(double x_px, double y_px) const {
  return std::any_of(shown_.panels.begin(), shown_.panels.end(),
                     [&](const Box& panel) { return panel.holds(x_px, y_px); });
}

bool PointerTouch::take(const InputEvent& event) {
  // What something else leads is not pointed at: the mouse is the view's.
  if (!input_.pointer_leads && event.kind != InputEvent::Kind::key) return false;
  const std::lock_guard lock(mutex_);
  const bool hit = event.kind != InputEvent::Kind::key && is_on_panel(event.x_px, event.y_px);
  bool taken = false;
  if (event.kind != InputEvent::Kind::key) {
    last_px_ = {event.x_px, event.y_px};
    if (std::exchange(led_by_keys_, false)) is_turned_ = false;  // it comes to the view as that is
  }
  switch (event.kind) {
    case InputEvent::Kind::key: {
      const auto action = action_of(event.key, touch_window_kind(input_));
      return action && take_key(*action, event.t_s);
    }
    case InputEvent::Kind::press:
      on_panel_ = hit;
      beside_panels_ = !hit;
      if (hit) return false;
      held_ = over_ = taken = point_at(event.x_px, event.y_px);
      turns_view_ = !taken && shown_.scene.holds(event.x_px, event.y_px);
      break;
    case InputEvent::Kind::move:
      // A panel's own, unless the button is held that was pressed beside it; the view's, if beside the part.
      if (turns_view_ || on_panel_ || (hit && !beside_panels_)) return false;
      over_ = point_at(event.x_px, event.y_px);
      // Off the edge of the part a held finger lifts until the pointer is back.
      if (!over_ && !held_) return false;
      taken = true;
      break;
    case InputEvent::Kind::release:
      beside_panels_ = turns_view_ = false;
      if (std::exchange(on_panel_, false)) return false;
      taken = std::exchange(held_, false);
      break;
  }
  press();
  tell(event.t_s);
  return taken;
}

bool PointerTouch::take_key(KeyAction action, double t_s) {
  const double step_px = 0.004 * shown_.scene.height;
  const Vec3 right_m = 1e-3 * step_px * shown_.lines.right_mm, up_m = 1e-3 * step_px * shown_.lines.up_mm;
  switch (action) {
    case KeyAction::stop:
    case KeyAction::give_back:
      input_.set_stop(action == KeyAction::stop);
      return true;
    case KeyAction::press:
      latched_ = !latched_;
      press();
      break;
    case KeyAction::go_left:
    case KeyAction::go_right:
      target_.move_by(action == KeyAction::go_left ? Vec3(-right_m) : right_m, shown_.towards_eye_W,
                      shown_.finger_W);
      led_by_keys_ = true;
      break;
    case KeyAction::go_up:
    case KeyAction::go_down:
      target_.move_by(action == KeyAction::go_down ? Vec3(-up_m) : up_m, shown_.towards_eye_W,
                      shown_.finger_W);
      led_by_keys_ = true;
      break;
    case KeyAction::harder:
    case KeyAction::softer:
      target_.change_force(action == KeyAction::harder ? 1 : -1);
      break;
    default:
      return false;
  }
  tell(t_s);
  return true;
}

/// False where there is nothing to touch under the mouse.
bool PointerTouch::point_at(double x_px, double y_px) {
  is_turned_ = false;
  if (!shown_.scene.holds(x_px, y_px)) return false;
  const Vec3 beside_mm = x_px * shown_.lines.right_mm + y_px * shown_.lines.up_mm;
  const Vec3 near_mm = shown_.lines.near_mm + beside_mm, far_mm = shown_.lines.far_mm + beside_mm;
  const auto hit = first_hit_(near_mm, far_mm);
  if (!hit) return false;
  // Seen from the back of an open part the finger is on this side too.
  const bool from_behind = hit->normal_W.dot(far_mm - near_mm) > 0;
  const Vec3 seen_W = from_behind ? Vec3(-hit->normal_W) : hit->normal_W;
  hit->on_rim ? target_.point_at_rim(hit->point_W, seen_W, hit->surface)
              : target_.point_at(hit->point_W, seen_W, hit->surface);
  return true;
}

/// Whether, by the button and the key that latches; which is not ended by a pointer that goes elsewhere.
void PointerTouch::press() {
  target_.press(latched_ || (held_ && over_));
  has_pressed_ |= target_.pressing();
}

/// Hands on what an event has changed, with the event's time: speeds are the pointer's, not the frames'. The
/// wheel's, which waits for a frame, may come after one that was later.
void PointerTouch::tell(double t_s) {
  if (input_.look_from) input_.look_from(shown_.towards_eye_W);
  FingerSample target = target_.sample();
  target.t_s = told_s_ = std::max(told_s_, t_s);
  input_.set_target(target);
}

void PointerTouch::change_force(int steps, double t_s) {
  const std::lock_guard lock(mutex_);
  target_.change_force(steps);
  tell(t_s);
}

bool PointerTouch::pressing() const {
  const std::lock_guard lock(mutex_);
  return target_.pressing();
}

bool PointerTouch::has_pressed() const {
  const std::lock_guard lock(mutex_);
  return has_pressed_;
}

bool PointerTouch::turns_view() const {
  const std::lock_guard lock(mutex_);
  return turns_view_;
}

double PointerTouch::press_n() const {
  const std::lock_guard lock(mutex_);
  return target_.press_n();
}

Vec3 PointerTouch::pressed_W() const {
  const std::lock_guard lock(mutex_);
  return target_.pressed_W();
}

bool PointerTouch::is_kept_from_spot(const Vec3& finger_W) const {
  const std::lock_guard lock(mutex_);
  return (over_ || latched_) && target_.is_kept_from_spot(finger_W);
}

}  // namespace fingerpad
