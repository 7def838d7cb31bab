#pragma once

#include <functional>
#include <vector>

#include "motion/finger_path.hpp"
#include "touch/time_histogram.hpp"
#include "touch/touch_swap.hpp"
#include "view/window.hpp"

namespace fingerpad {

/// A live touch as its window sees it. The functions are called on the window's thread; they must not wait
/// for the servo.
struct TouchWindowInput {
  ViewInput view;  ///< world and scene; rows empty
  /// Where the finger is wanted: under the mouse, at the time of its event, and what to press with
  /// (push_W_n). On the thread of the event, one at a time, as look_from and set_stop.
  std::function<void(const FingerSample&)> set_target;
  /// From where the one at the mouse looks, before each set_target. May be none.
  std::function<void(const Vec3& towards_eye_W)> look_from;
  /// The newest tick.
  std::function<TickRecord()> latest;
  /// The ticks of the last seconds, oldest first; may begin later.
  std::function<std::vector<TickRecord>(double seconds)> recent;
  /// Holds the force on a device at 0, or gives it back, and whether it is held; none where it has no motors.
  std::function<void(bool on)> set_stop;
  std::function<bool()> is_stopped;
  /// Whether the touch is over, so that the window closes; asked once a frame. May be none.
  std::function<bool()> is_over;
  /// What has gone wrong and is to be seen at once; empty: nothing. Asked once a frame. May be none.
  std::function<std::string()> alarm;
  /// Through which the material is changed while it is touched; may be none.
  TouchSwap* swap = nullptr;
  /// How the servo loop keeps its time, for the head-up display; may be none.
  std::function<ServoTiming()> timing;
  /// The servo keeps its pace whatever else there is to do, as under SCHED_FIFO: drawing need not stand back.
  bool keeps_pace = false;
  /// The finger follows the mouse: without, nobody is told how to press with it.
  bool pointer_leads = true;
  std::function<std::string()> note;  ///< in the title line, as "recording run.h5"; may be none
};

/// Opens a window on a live touch and returns when it is closed. The finger is under the mouse: it hovers
/// over the part, and presses while the left button is held or space is on; wheel, Page Up and Page Down
/// change how hard, the arrow keys move it, `h` shows all keys.
///
/// Throws Error (usage) where there is no display.
void run_touch_window(const TouchWindowInput& input, const WindowOptions& options);

}  // namespace fingerpad
