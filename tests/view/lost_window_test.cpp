#include "view/lost_window_vtk.hpp"

#include <X11/Xlib.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace fingerpad {
namespace {

constexpr std::uintptr_t window = 42;

/// As X tells of a window that is gone.
void lose_the_window() {
  XErrorEvent error{};
  error.resourceid = window;
  XSetErrorHandler(nullptr)(nullptr, &error);
}

// Seen once: memory was written over by a thread that drew, and its end took the trace away.
TEST(LostWindowDeathTest, AThreadThatFailsWaitsUntilAllIsSaved) {
  EXPECT_EXIT(
      {
        const LostWindowWatch watch(window, [] {
          std::thread([] { std::abort(); }).detach();
          std::this_thread::sleep_for(std::chrono::milliseconds(100));
          std::_Exit(7);
        });
        lose_the_window();
      },
      testing::ExitedWithCode(7), "");
}

TEST(LostWindowDeathTest, WhatSavesFailsAtOnce) {
  EXPECT_EXIT(
      {
        const LostWindowWatch watch(window, [] { std::abort(); });
        lose_the_window();
      },
      testing::KilledBySignal(SIGABRT), "");
}

TEST(LostWindowDeathTest, AThreadFailsAsBeforeWhereNoWindowIsLost) {
  EXPECT_EXIT(
      {
        const LostWindowWatch watch(window, [] { std::_Exit(7); });
        std::thread([] { std::abort(); }).join();
      },
      testing::KilledBySignal(SIGABRT), "");
}

}  // namespace
}  // namespace fingerpad
