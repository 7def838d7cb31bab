#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

#include "view/event_clock.hpp"
#include "view/input_event.hpp"

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace fingerpad {

/// What the window system sends to a window, with the time at which each thing happened. A thread of its own
/// hears of events, so that what can be answered at once is, however long a frame takes; the window's thread
/// gets them in their order when it has time.
class EventQueue {
 public:
  /// The thread starts here, so that it does not stand back where the window's thread does later.
  /// @param at_once  may be none
  explicit EventQueue(AtOnce at_once);
  ~EventQueue();
  EventQueue(const EventQueue&) = delete;
  EventQueue& operator=(const EventQueue&) = delete;

  /// Hears of the window's events from now on. @param interactor  initialised
  void open(vtkRenderWindowInteractor* interactor, vtkRenderWindow* window);

  /// Whether the window system is one whose events are known here (X).
  bool is_known() const noexcept;
  /// Hands the next event to the interactor; false where none waits. @pre is_known()
  bool pass_on();
  /// Returns when an event waits, or after so many seconds. @pre is_known()
  void wait(double seconds);

  /// Asks the window manager to let nobody make the window smaller.
  void refuse_smaller(int width_px, int height_px);

  /// When the event that is being passed on was made; now, where there is none. Steady [s].
  double event_s() const;
  /// Whether an event is being passed on, and whether it was taken at once.
  bool is_passing() const noexcept { return passing_; }
  bool was_taken() const noexcept { return taken_; }

 private:
  struct Heard;
  void listen();
  void hear_all();
  std::uintptr_t window_id() const;

  AtOnce at_once_;
  std::unique_ptr<Heard> heard_;
  vtkRenderWindowInteractor* interactor_ = nullptr;
  vtkRenderWindow* window_ = nullptr;
  bool passing_ = false, taken_ = false;
  double event_s_ = 0;
  std::thread listener_;
};

}  // namespace fingerpad
