#pragma once

#include <csignal>

namespace fingerpad {

/// While it lives SIGINT and SIGTERM ask the program to end what it has begun and stop. A second one of a
/// kind ends it at once.
class StopRequest {
 public:
  StopRequest();
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  /// Whether one has come.
  bool come() const noexcept;
  /// Whether SIGINT has.
  bool come_by_interrupt() const noexcept;

 private:
  struct sigaction before_int_ {
  }, before_term_{};
};

}  // namespace fingerpad
