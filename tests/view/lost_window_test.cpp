#include "view/lost_window_vtk.hpp"

#include <X11/Xlib.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
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

/// Fails on another thread, and returns when that is about to.
void fail_elsewhere(int failure) {
  std::atomic_flag begun;
  std::thread([&begun, failure] {
    begun.test_and_set();
    begun.notify_one();
    std::raise(failure);
  }).detach();
  begun.wait(false);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
}

// Seen once: memory was written over by a thread that drew, and its end took the trace away.
TEST(LostWindowDeathTest, AThreadThatFailsWaitsUntilAllIsSaved) {
  for (const int failure : {SIGABRT, SIGSEGV}) {
    const auto save = [failure] {
      fail_elsewhere(failure);
      std::_Exit(7);
    };
    EXPECT_EXIT(
        {
          const LostWindowWatch watch(window, save);
          lose_the_window();
        },
        testing::ExitedWithCode(7), "");
  }
}

TEST(LostWindowDeathTest, AThreadThatFailsBeforeXTellsOfTheLossWaitsToo) {
  EXPECT_EXIT(
      {
        const LostWindowWatch watch(window, [] { std::_Exit(7); });
        fail_elsewhere(SIGSEGV);
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

TEST(LostWindowDeathTest, WhatFailedBeforeTheWatchFailsSoAfterIt) {
  const auto own = [](int) { std::_Exit(5); };
  EXPECT_EXIT(
      {
        std::signal(SIGSEGV, own);
        {
          const LostWindowWatch watch(window, [] { std::_Exit(7); });
        }
        std::raise(SIGSEGV);
      },
      testing::ExitedWithCode(5), "");
}

}  // namespace
}  // namespace fingerpad
