#pragma once

#include <csignal>

namespace fingerpad {

/// While it lives SIGINT, SIGTERM and SIGHUP ask to stop, so that what is under way can be brought to an end:
/// a trace made whole, a terminal left as it was. A second SIGINT ends the program at once; other signals
/// that come again change nothing. One that the program was started to ignore stays ignored. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  bool has_come() const noexcept;
  /// Waits for one, at most so long. @returns whether one has come
  bool wait(double seconds) const noexcept;

 private:
  static constexpr int count = 3;
  struct sigaction before_[count] {};
};

}  // namespace fingerpad
