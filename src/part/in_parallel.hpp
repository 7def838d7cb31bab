#pragma once

#include <algorithm>
#include <future>
#include <thread>
#include <vector>

namespace fingerpad {

/// Does `body(begin, end)` for ranges that together are 0 .. count - 1, on all threads where there are enough
/// to be worth it. What a body writes must belong to its own numbers: then the result does not depend on the
/// threads. Waits for all; throws what a body threw.
/// @param worth_a_thread  so many numbers are
template <typename Body>
void in_parallel(int count, Body&& body, int worth_a_thread = 25000) {
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int ranges = std::clamp(count / worth_a_thread, 1, threads);
  const auto border = [&](int i) { return static_cast<int>(static_cast<long>(count) * i / ranges); };
  std::vector<std::future<void>> others;  // each waits for its thread where this one throws
  for (int i = 1; i < ranges; ++i) {
    others.push_back(std::async(std::launch::async, [&, i] { body(border(i), border(i + 1)); }));
  }
  body(0, border(1));
  for (std::future<void>& other : others) other.get();
}

}  // namespace fingerpad
