#pragma once

namespace fingerpad {

/// Wakes a thread that polls it. wake() may be called by a thread that must not wait.
class WakeUp {
 public:
  /// Throws Error (fault) where the system has none left.
  WakeUp();
  ~WakeUp();
  WakeUp(const WakeUp&) = delete;
  WakeUp& operator=(const WakeUp&) = delete;

  int descriptor() const noexcept { return descriptor_; }
  void wake() noexcept;
  /// Waits for a call of wake() since the last clear(), for at most so long. @returns whether there was one
  bool wait(int patience_ms) noexcept;
  void clear() noexcept;

 private:
  int descriptor_ = -1;
};

}  // namespace fingerpad
