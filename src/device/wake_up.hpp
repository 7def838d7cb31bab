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
  /// What ended a wait.
  struct Woken {
    bool by_wake = false, by_other = false;
    bool broken = false;  ///< nothing can be waited for here
  };
  /// Waits without end for a call of wake() or for something to read at another descriptor, its end included.
  Woken wait_with(int other_descriptor) noexcept;
  void clear() noexcept;

 private:
  int descriptor_ = -1;
};

}  // namespace fingerpad
