#include "view/event_queue_vtk.hpp"

#include <X11/Xutil.h>
#include <poll.h>
#include <vtkRenderWindow.h>
#include <vtkXRenderWindowInteractor.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

namespace fingerpad {
namespace {

/// The window's thread, too, reads from the connection, and leaves events in Xlib's own queue: nothing tells
/// of those, so they are looked for every so often.
constexpr int look_ms = 8;

double steady_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The server's time of what a person did; none for other events.
std::optional<unsigned long> server_ms(const XEvent& event) {
  switch (event.type) {
    case MotionNotify:
      return event.xmotion.time;
    case EnterNotify:
      return event.xcrossing.time;
    case ButtonPress:
    case ButtonRelease:
      return event.xbutton.time;
    case KeyPress:
    case KeyRelease:
      return event.xkey.time;
    default:
      return std::nullopt;
  }
}

/// What can be answered at once; none: it cannot.
std::optional<InputEvent> input_of(XEvent& event, int height_px, double t_s) {
  InputEvent input;
  input.t_s = t_s;
  const auto at = [&](int x_px, int y_px) {
    input.x_px = x_px;
    input.y_px = height_px - 1 - y_px;
  };
  switch (event.type) {
    case MotionNotify:
      at(event.xmotion.x, event.xmotion.y);
      return input;
    case EnterNotify:  // a window that opens under the pointer is told of it so, and of no move
      // Of a held button's pointer every move is told, in the window or not. Where one that rests enters a
      // window, this was made larger, and has drawn no frame yet by which to tell what is under it.
      if ((event.xcrossing.state & Button1Mask) != 0) return std::nullopt;
      at(event.xcrossing.x, event.xcrossing.y);
      return input;
    case ButtonPress:
    case ButtonRelease:
      if (event.xbutton.button != Button1) return std::nullopt;
      input.kind = event.type == ButtonPress ? InputEvent::Kind::press : InputEvent::Kind::release;
      at(event.xbutton.x, event.xbutton.y);
      return input;
    case KeyPress: {
      char letters[20];
      KeySym symbol = NoSymbol;
      XLookupString(&event.xkey, letters, sizeof(letters), &symbol, nullptr);
      const char* const name = XKeysymToString(symbol);
      input.kind = InputEvent::Kind::key;
      input.key = name != nullptr ? name : "";
      return input;
    }
    default:
      return std::nullopt;
  }
}

/// VTK asks for hints: of a pointer that goes on, X tells one move and no more until VTK has looked where the
/// pointer is, with its next frame. Whoever takes that one at once would stay where it was then.
void ask_for_every_move(Display* display, Window window) {
  XWindowAttributes now{};
  if (XGetWindowAttributes(display, window, &now) == 0) return;
  XSelectInput(display, window, now.your_event_mask & ~PointerMotionHintMask);
}

}  // namespace

struct EventQueue::Heard {
  struct Waiting {
    XEvent event;
    double t_s;
    bool taken;
  };
  std::mutex mutex;
  std::condition_variable changed;
  Display* display = nullptr;  // from open() on
  bool closing = false;
  std::deque<Waiting> waiting;
  /// Of moves that follow one another the window's thread needs the last: a mouse may make a thousand a
  /// second.
  void put(const Waiting& one) {
    const bool follows = !waiting.empty() && waiting.back().event.type == MotionNotify &&
                         one.event.type == MotionNotify && waiting.back().taken == one.taken;
    if (follows) waiting.pop_back();
    waiting.push_back(one);
  }
  // The listener's.
  EventClock clock;
  int height_px = 0;
};

EventQueue::EventQueue(AtOnce at_once) : at_once_(std::move(at_once)), heard_(std::make_unique<Heard>()) {
  XInitThreads();
  listener_ = std::thread([this] { listen(); });
}

EventQueue::~EventQueue() {
  {
    const std::lock_guard lock(heard_->mutex);
    heard_->closing = true;
  }
  heard_->changed.notify_all();
  listener_.join();
}

void EventQueue::open(vtkRenderWindowInteractor* interactor, vtkRenderWindow* window) {
  interactor_ = interactor;
  window_ = window;
  if (vtkXRenderWindowInteractor::SafeDownCast(interactor) == nullptr) return;
  ask_for_every_move(static_cast<Display*>(window->GetGenericDisplayId()), window_id());
  {
    const std::lock_guard lock(heard_->mutex);
    heard_->height_px = window->GetSize()[1];
    heard_->display = static_cast<Display*>(window->GetGenericDisplayId());
  }
  heard_->changed.notify_all();
}

/// VTK gives X's number of the window as a pointer.
std::uintptr_t EventQueue::window_id() const {
  return reinterpret_cast<std::uintptr_t>(window_->GetGenericWindowId());
}

bool EventQueue::is_known() const noexcept {
  return heard_->display != nullptr;
}

void EventQueue::listen() {
  {
    std::unique_lock lock(heard_->mutex);
    heard_->changed.wait(lock, [this] { return heard_->closing || heard_->display != nullptr; });
  }
  for (;;) {
    {
      const std::lock_guard lock(heard_->mutex);
      if (heard_->closing) return;
    }
    hear_all();
    pollfd connection{ConnectionNumber(heard_->display), POLLIN, 0};
    poll(&connection, 1, look_ms);
  }
}

void EventQueue::hear_all() {
  while (XPending(heard_->display) > 0) {
    Heard::Waiting one{};
    XNextEvent(heard_->display, &one.event);
    if (one.event.type == ConfigureNotify) heard_->height_px = one.event.xconfigure.height;
    const auto made_ms = server_ms(one.event);
    one.t_s = made_ms ? heard_->clock.time_s(*made_ms, steady_s()) : steady_s();
    if (at_once_) {
      const auto input = input_of(one.event, heard_->height_px, one.t_s);
      one.taken = input && at_once_(*input);
    }
    {
      const std::lock_guard lock(heard_->mutex);
      heard_->put(one);
    }
    heard_->changed.notify_all();
  }
}

bool EventQueue::pass_on() {
  Heard::Waiting next{};
  {
    const std::lock_guard lock(heard_->mutex);
    if (heard_->waiting.empty()) return false;
    next = heard_->waiting.front();
    heard_->waiting.pop_front();
  }
  event_s_ = next.t_s;
  taken_ = next.taken;
  passing_ = true;
  static_cast<vtkXRenderWindowInteractor*>(interactor_)->DispatchEvent(&next.event);
  passing_ = taken_ = false;
  return true;
}

void EventQueue::wait(double seconds) {
  std::unique_lock lock(heard_->mutex);
  heard_->changed.wait_for(lock, std::chrono::duration<double>(seconds),
                           [this] { return !heard_->waiting.empty(); });
}

void EventQueue::refuse_smaller(int width_px, int height_px) {
  if (!is_known()) return;
  XSizeHints hints{};
  hints.flags = PMinSize;
  hints.min_width = width_px;
  hints.min_height = height_px;
  XSetWMNormalHints(heard_->display, window_id(), &hints);
}

double EventQueue::event_s() const {
  return passing_ ? event_s_ : steady_s();
}

}  // namespace fingerpad
