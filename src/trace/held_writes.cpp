#include "trace/held_writes.hpp"

#include <algorithm>
#include <new>
#include <tuple>

namespace fingerpad {

bool HeldWrites::hold(std::uint64_t at, std::span<const std::byte> bytes) noexcept {
  const bool overlaps = std::any_of(held_.begin(), held_.end(), [&](const Held& held) {
    return at < held.at + held.size && held.at < at + bytes.size();
  });
  if (overlaps) return false;
  try {
    const std::size_t first = bytes_.size();
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    held_.push_back({at, first, bytes.size()});
  } catch (const std::bad_alloc&) {  // bytes that nothing names go with the rest
    return false;
  }
  return true;
}

void HeldWrites::put_in_order(std::uint64_t new_from) noexcept {
  const auto rank = [new_from](const Held& held) {
    const int kind = held.at == 0 ? 0 : held.at >= new_from ? 1 : 2;
    return std::tuple(kind, held.at);
  };
  std::sort(held_.begin(), held_.end(), [&](const Held& a, const Held& b) { return rank(a) < rank(b); });
}

}  // namespace fingerpad
