#pragma once

#include "view/event_clock.hpp"

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace fingerpad {

/// What the window system sends to a window, with the time at which each thing happened: a slow frame keeps
/// events waiting, and how fast a pointer went shows in their own times alone.
class EventQueue {
 public:
  /// @param interactor  initialised
  EventQueue(vtkRenderWindowInteractor* interactor, vtkRenderWindow* window);

  /// Whether the window system is one whose events are known here (X).
  bool is_known() const noexcept { return display_ != nullptr; }
  /// Hands the next event to the interactor; false where none waits. @pre is_known()
  bool pass_on();
  /// Returns when an event waits, or after so many seconds. @pre is_known()
  void wait(double seconds);

  /// Asks the window manager to let nobody make the window smaller.
  void refuse_smaller(int width_px, int height_px);

  /// When the event that is being passed on was made; now, where there is none. Steady [s].
  double event_s() const;

 private:
  void stamp(unsigned long server_ms);

  vtkRenderWindowInteractor* interactor_;
  vtkRenderWindow* window_;
  void* display_ = nullptr;
  bool passing_ = false;
  EventClock clock_;
  double event_s_ = 0;
};

}  // namespace fingerpad
