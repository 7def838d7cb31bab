#pragma once

#include <array>
#include <atomic>

namespace fingerpad {

/// The latest value of one thread, for one other thread. Neither ever waits: there are three places, one that
/// is being written, one that is being read, and one with the latest whole value, which change hands by
/// single exchanges.
template <typename Value>
class Latest {
 public:
  /// Writer's thread.
  void put(const Value& value) noexcept {
    places_[written_] = value;
    written_ = shared_.exchange(written_ | fresh, std::memory_order_acq_rel) & place;
  }

  /// Reader's thread. @returns false, and leaves `value`, where nothing was put since the last call
  bool take(Value& value) noexcept {
    if ((shared_.load(std::memory_order_relaxed) & fresh) == 0) return false;
    read_ = shared_.exchange(read_, std::memory_order_acq_rel) & place;
    value = places_[read_];
    return true;
  }

 private:
  static constexpr unsigned place = 3, fresh = 4;
  std::array<Value, 3> places_{};
  unsigned written_ = 0, read_ = 1;  // each its own thread's
  std::atomic<unsigned> shared_{2};
};

}  // namespace fingerpad
