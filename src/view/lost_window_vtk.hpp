#pragma once

#include <cstdint>
#include <functional>

namespace fingerpad {

/// Hears that a window is taken away from outside, as by xkill: destroyed by another program, or with all of
/// its connection to the X server. X ends a program for that in the midst of what it does, and what draws
/// cannot go on. One at a time. A thread that fails of that waits for the end, ten seconds at most; one that
/// fails of anything else does so a fifth of a second later.
class LostWindowWatch {
 public:
  /// @param window   its number; errors about others end the program as before
  /// @param ending   what is to be ended well before the program ends; on the thread that finds the window
  ///                 gone, while the others go on but for X. It must not call X, and not return.
  LostWindowWatch(std::uintptr_t window, std::function<void()> ending);
  ~LostWindowWatch();
  LostWindowWatch(const LostWindowWatch&) = delete;
  LostWindowWatch& operator=(const LostWindowWatch&) = delete;
};

}  // namespace fingerpad
