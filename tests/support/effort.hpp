#pragma once

#include <initializer_list>
#include <vector>

namespace fingerpad::test {

/// Whether what is tested was built with the sanitizers, under which everything takes ten times as long.
bool sanitized() noexcept;

/// How many samples a test takes: all, or a tenth under the sanitizers.
inline int samples(int count) {
  return sanitized() ? count / 10 : count;
}

/// Cases that all go the same way through the code: all, or the first alone under the sanitizers.
template <class Case>
std::vector<Case> cases(std::initializer_list<Case> listed) {
  std::vector<Case> all = listed;
  if (sanitized()) all.erase(all.begin() + 1, all.end());
  return all;
}

/// Whether a child that was forked beside other threads can allocate. The address sanitizer of GCC 12 does
/// not free its allocator's locks in the child: where a thread held one, the child waits until its alarm.
inline bool forks_beside_threads() {
  return !sanitized();
}

}  // namespace fingerpad::test
