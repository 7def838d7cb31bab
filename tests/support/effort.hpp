#pragma once

#include <initializer_list>
#include <vector>

namespace fingerpad::test {

/// How many samples a test takes: all, or a tenth under a sanitizer, where each costs ten times as much.
constexpr int samples(int count) {
#if defined(__SANITIZE_ADDRESS__)
  return count / 10;
#else
  return count;
#endif
}

/// Cases that all go the same way through the code: all, or the first alone under a sanitizer.
template <class Case>
std::vector<Case> cases(std::initializer_list<Case> listed) {
  std::vector<Case> all = listed;
#if defined(__SANITIZE_ADDRESS__)
  all.erase(all.begin() + 1, all.end());
#endif
  return all;
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
