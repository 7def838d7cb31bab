#pragma once

namespace fingerpad::test {

/// How many samples a test takes: all, or a tenth under a sanitizer, where each costs ten times as much.
constexpr int samples(int count) {
#if defined(__SANITIZE_ADDRESS__)
  return count / 10;
#else
  return count;
#endif
}

/// Whether a child that was forked beside other threads can allocate. The address sanitizer of GCC 12 does
/// not free its allocator's locks in the child: where a thread held one, the child waits until its alarm.
constexpr bool forks_beside_threads() {
#if defined(__SANITIZE_ADDRESS__)
  return false;
#else
  return true;
#endif
}

}  // namespace fingerpad::test
