#include "app/stop_request.hpp"

#include <atomic>

namespace fingerpad {
namespace {

// A handler reaches nothing but what is global.
std::atomic<bool> stop_requested{false}, interrupt_come{false};

void request_stop(int signal) {
  if (signal == SIGINT) interrupt_come = true;
  stop_requested = true;
}

}  // namespace

StopRequest::StopRequest() {
  stop_requested = interrupt_come = false;
  struct sigaction action {};
  action.sa_handler = request_stop;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &before_int_);
  sigaction(SIGTERM, &action, &before_term_);
}

StopRequest::~StopRequest() {
  sigaction(SIGINT, &before_int_, nullptr);
  sigaction(SIGTERM, &before_term_, nullptr);
}

bool StopRequest::come() const noexcept {
  return stop_requested;
}

bool StopRequest::come_by_interrupt() const noexcept {
  return interrupt_come;
}

}  // namespace fingerpad
