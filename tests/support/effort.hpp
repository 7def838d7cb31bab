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

}  // namespace fingerpad::test
