#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <vector>

#include "touch/tick_record.hpp"

namespace fingerpad {

/// The last ticks of one thread, for any number of others: the newest, or all that are still there. Nobody
/// waits. A reader that is overtaken by the writer finds by a place's number that it holds another tick by
/// now, and drops it; the words themselves are atomic, so that no reader sees a torn one for a whole.
class RecordRing {
 public:
  explicit RecordRing(std::size_t capacity) : places_(capacity < 2 ? 2 : capacity) {}

  /// One thread. noexcept, allocates nothing.
  void put(const TickRecord& record) noexcept {
    const std::uint64_t number = put_.load(std::memory_order_relaxed) + 1;
    Place& place = places_[number % places_.size()];
    Words words;
    std::memcpy(words.data(), static_cast<const void*>(&record), sizeof(record));
    place.number.store(0, std::memory_order_relaxed);
    // Each releases the 0 before it: who sees a new word sees that the place is being written.
    for (std::size_t i = 0; i < words.size(); ++i) place.words[i].store(words[i], std::memory_order_release);
    place.number.store(number, std::memory_order_release);
    put_.store(number, std::memory_order_release);
  }

  /// How many were put so far. The newest has this number, the first 1.
  std::uint64_t count() const noexcept { return put_.load(std::memory_order_acquire); }
  std::size_t capacity() const noexcept { return places_.size(); }

  /// @returns false where that tick is not there any more, or not yet
  bool get(std::uint64_t number, TickRecord& record) const noexcept {
    const Place& place = places_[number % places_.size()];
    if (number == 0 || place.number.load(std::memory_order_acquire) != number) return false;
    Words words;
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = place.words[i].load(std::memory_order_acquire);
    if (place.number.load(std::memory_order_relaxed) != number) return false;
    std::memcpy(static_cast<void*>(&record), words.data(), sizeof(record));
    return true;
  }

 private:
  static constexpr std::size_t word_count = (sizeof(TickRecord) + 7) / 8;
  using Words = std::array<std::uint64_t, word_count>;
  struct Place {
    std::atomic<std::uint64_t> number{0};  ///< of the tick here; 0 while it is being written
    std::array<std::atomic<std::uint64_t>, word_count> words{};
  };

  std::vector<Place> places_;
  std::atomic<std::uint64_t> put_{0};
};

}  // namespace fingerpad
