#include "view/lost_window_vtk.hpp"

#include <X11/Xlib.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <ctime>
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

constexpr std::array failures{SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV};
std::array<struct sigaction, failures.size()> other_failures;

void fail_as_before() {
  for (std::size_t i = 0; i < failures.size(); ++i) sigaction(failures[i], &other_failures[i], nullptr);
}

void wait_ms(long ms) {
  const timespec span{ms / 1000, ms % 1000 * 1'000'000};
  nanosleep(&span, nullptr);
}

/// A thread that draws may fail of what is gone, before X tells of it or after: it must not take with it what
/// is being saved. For as long as that usually takes: it may hold a lock that is waited for.
void fail_later(int failure) {
  constexpr int told_within_ms = 200, saved_within_ms = 10'000, step_ms = 10;
  if (gettid() != saving_thread) {
    for (int left_ms = told_within_ms; left_ms > 0 && !window_ends.test(); left_ms -= step_ms)
      wait_ms(step_ms);
    for (int left_ms = saved_within_ms; left_ms > 0 && window_ends.test(); left_ms -= step_ms)
      wait_ms(step_ms);
  }
  fail_as_before();
  std::raise(failure);
}

void hear_failures() {
  struct sigaction ours {};
  ours.sa_handler = fail_later;
  sigemptyset(&ours.sa_mask);
  for (std::size_t i = 0; i < failures.size(); ++i) sigaction(failures[i], &ours, &other_failures[i]);
}

/// Once. A thread that comes second waits here for the program's end: what it draws into is gone.
[[noreturn]] void end_without_window() {
  if (!window_ends.test_and_set()) {
    saving_thread = gettid();
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
  hear_failures();
}

LostWindowWatch::~LostWindowWatch() {
  // Another thread may have found the loss and be saving what there is: it ends the program.
  while (window_ends.test()) pause();
  fail_as_before();
  XSetErrorHandler(other_errors);
  XSetIOErrorHandler(other_connection_errors);
  watched_window = 0;
}

}  // namespace fingerpad
