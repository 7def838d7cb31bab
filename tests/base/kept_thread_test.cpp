#include "base/kept_thread.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include <sys/resource.h>
#include <unistd.h>

namespace fingerpad::kept_thread_test {
namespace {

/// How far the calling thread stands back.
int own_nice() {
  return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
}

int nice_of_a_new_thread() {
  int nice = -100;
  std::thread([&nice] { nice = own_nice(); }).join();
  return nice;
}

TEST(KeptThread, WhatIsBegunThereDoesNotStandBackWithItsMaker) {
  const int before = own_nice();
  if (before > 18) GTEST_SKIP() << "no thread can stand back further";
  int straight = -100, kept = -100;
  std::thread([&] {  // which ends: the tests' own thread could not come forward again
    KeptThread thread;
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), before + 1);
    straight = nice_of_a_new_thread();
    kept = thread.run([] { return nice_of_a_new_thread(); });
  })
      .join();
  EXPECT_EQ(straight, before + 1);
  EXPECT_EQ(kept, before);
}

TEST(KeptThread, GivesBackWhatIsThrownAndGoesOn) {
  KeptThread thread;
  EXPECT_THROW(thread.run([] { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_NE(thread.run([] { return gettid(); }), gettid());
}

}  // namespace
}  // namespace fingerpad::kept_thread_test
