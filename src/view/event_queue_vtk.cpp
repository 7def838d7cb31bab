#include "view/event_queue_vtk.hpp"

#include <X11/Xutil.h>
#include <poll.h>
#include <vtkRenderWindow.h>
#include <vtkXRenderWindowInteractor.h>

#include <chrono>
#include <cmath>

namespace fingerpad {
namespace {

double steady_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

EventQueue::EventQueue(vtkRenderWindowInteractor* interactor, vtkRenderWindow* window)
    : interactor_(interactor), window_(window) {
  if (vtkXRenderWindowInteractor::SafeDownCast(interactor) != nullptr)
    display_ = window->GetGenericDisplayId();
}

void EventQueue::stamp(unsigned long server_ms) {
  event_s_ = clock_.time_s(server_ms, steady_s());
  passing_ = true;
}

bool EventQueue::pass_on() {
  auto* const display = static_cast<Display*>(display_);
  if (XPending(display) == 0) return false;
  XEvent event;
  XNextEvent(display, &event);
  if (event.type == MotionNotify) stamp(event.xmotion.time);
  if (event.type == EnterNotify) stamp(event.xcrossing.time);
  if (event.type == ButtonPress || event.type == ButtonRelease) stamp(event.xbutton.time);
  if (event.type == KeyPress || event.type == KeyRelease) stamp(event.xkey.time);
  static_cast<vtkXRenderWindowInteractor*>(interactor_)->DispatchEvent(&event);
  passing_ = false;
  return true;
}

void EventQueue::wait(double seconds) {
  auto* const display = static_cast<Display*>(display_);
  if (XPending(display) > 0) return;
  pollfd connection{ConnectionNumber(display), POLLIN, 0};
  poll(&connection, 1, static_cast<int>(std::ceil(1e3 * seconds)));
}

void EventQueue::refuse_smaller(int width_px, int height_px) {
  if (!is_known()) return;
  XSizeHints hints{};
  hints.flags = PMinSize;
  hints.min_width = width_px;
  hints.min_height = height_px;
  // VTK gives X's number of the window as a pointer.
  const auto id = reinterpret_cast<std::uintptr_t>(window_->GetGenericWindowId());
  XSetWMNormalHints(static_cast<Display*>(display_), static_cast<Window>(id), &hints);
}

double EventQueue::event_s() const {
  return passing_ ? event_s_ : steady_s();
}

}  // namespace fingerpad
