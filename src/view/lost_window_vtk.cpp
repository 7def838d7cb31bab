#include "view/lost_window_vtk.hpp"

#include <X11/Xlib.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <utility>

namespace fingerpad {
namespace {

// X's handlers are one for the whole program, and are given nothing of ours.
std::atomic<std::uintptr_t> watched_window{0};
std::function<void()> window_ending;
std::atomic_flag window_ends;
std::atomic<pid_t> saving_thread{0};
XErrorHandler other_errors = nullptr;
XIOErrorHandler other_connection_errors = nullptr;

/// The threads that draw may fail of what is gone, before X tells them of it: they must not take with them
/// what is being saved. As long as that can take, and no longer: they may hold a lock that it waits for.
void fail_later(int signal) {
  constexpr int saved_within_s = 10;
  if (gettid() != saving_thread) {
    for (unsigned left_s = saved_within_s; left_s > 0;) left_s = sleep(left_s);
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Once. A thread that comes second waits here for the program's end: what it draws into is gone.
[[noreturn]] void end_without_window() {
  if (!window_ends.test_and_set()) {
    saving_thread = gettid();
    for (const int failure : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) std::signal(failure, fail_later);
    window_ending();
  }
  for (;;) pause();
}

/// Whatever the request was: a frame under way ends with GLX's own error.
int take_error(Display* display, XErrorEvent* error) {
  if (error->resourceid == watched_window) end_without_window();
  return other_errors != nullptr ? other_errors(display, error) : 0;
}

int take_broken_connection(Display*) {
  end_without_window();
}

}  // namespace

LostWindowWatch::LostWindowWatch(std::uintptr_t window, std::function<void()> ending) {
  watched_window = window;
  window_ending = std::move(ending);
  other_errors = XSetErrorHandler(take_error);
  other_connection_errors = XSetIOErrorHandler(take_broken_connection);
}

LostWindowWatch::~LostWindowWatch() {
  // Another thread may have found the loss and be saving what there is: it ends the program.
  while (window_ends.test()) pause();
  XSetErrorHandler(other_errors);
  XSetIOErrorHandler(other_connection_errors);
  watched_window = 0;
}

}  // namespace fingerpad
