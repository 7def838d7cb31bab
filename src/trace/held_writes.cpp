#include "trace/held_writes.hpp"

#include <algorithm>
#include <new>

namespace fingerpad {
namespace {

// The smallest page of memory of any machine: a larger one ends where one of these does.
constexpr std::uint64_t page_bytes = 4096;

}  // namespace

bool HeldWrites::hold(std::uint64_t at, std::span<const std::byte> bytes) noexcept {
  const bool overlaps = std::any_of(held_.begin(), held_.end(), [&](const Held& held) {
    return at < held.at + held.size && held.at < at + bytes.size();
  });
  if (overlaps) return false;
  try {
    held_.reserve(held_.size() + 1);
    const std::size_t first = bytes_.size();
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    held_.push_back({at, first, bytes.size()});
  } catch (const std::bad_alloc&) {
    return false;
  }
  return true;
}

void HeldWrites::put_in_order() noexcept {
  std::sort(held_.begin(), held_.end(),
            [](const Held& a, const Held& b) { return a.at == 0 ? b.at > 0 : b.at > 0 && a.at > b.at; });
}

/// Where the last page begins of the first `end` bytes of what is written to `at`.
std::size_t HeldWrites::start_of_page(std::uint64_t at, std::size_t end) noexcept {
  const std::uint64_t in_page = (at + end - 1) % page_bytes + 1;
  return end - static_cast<std::size_t>(std::min<std::uint64_t>(in_page, end));
}

}  // namespace fingerpad
