// How the servo's thread stands with Linux' scheduler when nothing was asked for.
#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <string>

#include "touch/servo_thread.hpp"

namespace fingerpad::servo_turns_test {
namespace {

/// As <linux/sched/types.h> has it, which some C libraries define once more.
struct ThreadTerms {
  std::uint32_t size = sizeof(ThreadTerms), policy = 99;
  std::uint64_t flags = 0;
  std::int32_t nice = 99;
  std::uint32_t priority = 99;
  std::uint64_t runtime_ns = 0, deadline_ns = 0, period_ns = 0;
};

bool kernel_knows_short_turns() {
  utsname name{};
  uname(&name);
  int major = 0, minor = 0;
  return std::sscanf(name.release, "%d.%d", &major, &minor) == 2 &&
         (major > 6 || (major == 6 && minor >= 12));
}

TEST(ServoThread, AsksForShortTurnsAndStandsOtherwiseAsWhoBeganIt) {
  ThreadTerms terms;
  std::atomic<long> asked{-2};
  char name[16] = "";
  ServoThread servo(
      1000,
      [&](double) {
        if (asked.load() == -2) {
          pthread_getname_np(pthread_self(), name, sizeof(name));
          asked = syscall(SYS_sched_getattr, 0, &terms, sizeof(terms), 0);
          asked.notify_all();
        }
        return TickRecord();
      },
      0.1, false);
  asked.wait(-2);
  servo.stop();
  EXPECT_STREQ(name, ServoThread::thread_name);
  ASSERT_EQ(asked, 0);
  EXPECT_EQ(terms.policy, static_cast<std::uint32_t>(SCHED_OTHER));
  EXPECT_EQ(terms.nice, getpriority(PRIO_PROCESS, static_cast<id_t>(gettid())));
  if (!kernel_knows_short_turns()) GTEST_SKIP() << "an older kernel";
  EXPECT_EQ(terms.runtime_ns, 100'000u);
}

TEST(ServoThread, WarmsUpOnItsOwnThreadBeforeItsFirstTickAndBeforeItIsThere) {
  std::atomic<pid_t> warmed{0}, ticked{0};
  std::atomic<bool> in_order{false};
  ServoThread servo(
      1000,
      [&](double) {
        if (ticked == 0) in_order = warmed == gettid();
        ticked = gettid();
        ticked.notify_all();
        return TickRecord();
      },
      0.1, false, [&] { warmed = gettid(); });
  EXPECT_NE(warmed, 0) << "who began it finds it ready";
  ticked.wait(0);
  servo.stop();
  EXPECT_TRUE(in_order);
}

}  // namespace
}  // namespace fingerpad::servo_turns_test
