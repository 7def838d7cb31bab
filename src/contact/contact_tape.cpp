#include "contact/contact_tape.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <new>
#include <utility>

namespace fingerpad {
namespace {

/// What stands before a tick's holds.
struct Head {
  std::int32_t hold_count;
  bool started, placed, broken_off, behind;
};

/// A place on a surface.
struct Place {
  std::array<double, 3> point_W, normal_W;
  double depth_m;
};

struct Hold {
  std::int32_t surface, triangle;
  Place place;  ///< with its share of the depth
};

constexpr std::size_t most_tick_bytes = sizeof(Head) + 3 * sizeof(Hold) + sizeof(Place);

std::array<double, 3> packed(const Vec3& v) noexcept {
  return {v.x(), v.y(), v.z()};
}

Vec3 unpacked(const std::array<double, 3>& v) noexcept {
  return {v[0], v[1], v[2]};
}

/// A lone hold is mostly the whole contact: to the bit, as zeros have signs.
bool is_alike(const Place& a, const Place& b) noexcept {
  using Bits = std::array<std::uint64_t, sizeof(Place) / sizeof(double)>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

template <class T>
void put(std::byte*& at, const T& what) noexcept {
  std::memcpy(at, &what, sizeof what);
  at += sizeof what;
}

template <class T>
T take(const std::byte*& at) noexcept {
  T what;
  std::memcpy(&what, at, sizeof what);
  at += sizeof what;
  return what;
}

/// Marks a head whose one hold is the whole contact.
constexpr std::int32_t lone_hold = -1;

/// Of a tick that begins so.
std::size_t bytes_of(const Head& head) noexcept {
  if (head.hold_count == 0) return sizeof head;
  if (head.hold_count == lone_hold) return sizeof head + sizeof(Hold);
  return sizeof head + static_cast<std::size_t>(head.hold_count) * sizeof(Hold) + sizeof(Place);
}

}  // namespace

ContactTape::ContactTape(long ticks, std::size_t most_bytes) : expected_ticks_(ticks) {
  const auto count = static_cast<std::size_t>(std::max(ticks, 0L));
  capacity_ =
      std::min(most_bytes, count <= most_bytes / most_tick_bytes ? count * most_tick_bytes : most_bytes);
  bytes_.reset(new (std::nothrow) std::byte[capacity_]);
  if (!bytes_) capacity_ = 0;
}

void ContactTape::append(const Contact& contact) noexcept {
  if (is_spoiled_) return;
  if (capacity_ - size_ < most_tick_bytes) return spoil();
  std::byte* const begin = bytes_.get() + size_;
  std::byte* at = begin;
  Head head{contact.hold_count, contact.started, contact.placed, contact.broken_off, contact.behind};
  if (head.hold_count == 0) {
    put(at, head);
  } else {
    const Place whole{packed(contact.point_W), packed(contact.normal_W), contact.depth_m};
    std::array<Hold, 3> holds;
    for (std::size_t i = 0; i < static_cast<std::size_t>(head.hold_count); ++i) {
      const ContactHold& hold = contact.holds[i];
      holds[i] = {hold.surface, hold.triangle, {packed(hold.point_W), packed(hold.normal_W), hold.share_m}};
    }
    const bool is_lone = head.hold_count == 1 && is_alike(whole, holds[0].place);
    const int count = head.hold_count;
    if (is_lone) head.hold_count = lone_hold;
    put(at, head);
    for (int i = 0; i < count; ++i) put(at, holds[static_cast<std::size_t>(i)]);
    if (!is_lone) put(at, whole);
  }
  size_ += static_cast<std::size_t>(at - begin);
  ++ticks_;
}

void ContactTape::trim() noexcept {
  std::unique_ptr<std::byte[]> needed(new (std::nothrow) std::byte[size_]);
  if (!needed) return;
  std::copy_n(bytes_.get(), size_, needed.get());
  bytes_ = std::move(needed);
  capacity_ = size_;
}

bool ContactTape::Reader::next(Contact& contact) noexcept {
  if (at_ == tape_->size_) return false;
  const std::byte* const begin = tape_->bytes_.get() + at_;
  const std::byte* at = begin;
  const Head head = take<Head>(at);
  const bool is_lone = head.hold_count == lone_hold;
  contact.hold_count = is_lone ? 1 : head.hold_count;
  contact.started = head.started;
  contact.placed = head.placed;
  contact.broken_off = head.broken_off;
  contact.behind = head.behind;
  Place whole{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(contact.hold_count); ++i) {
    const Hold hold = take<Hold>(at);
    whole = hold.place;
    contact.holds[i] = {hold.surface, hold.triangle, unpacked(whole.point_W), unpacked(whole.normal_W),
                        whole.depth_m};
  }
  if (contact.hold_count > 0) {
    if (!is_lone) whole = take<Place>(at);
    contact.depth_m = whole.depth_m;
    contact.point_W = unpacked(whole.point_W);
    contact.normal_W = unpacked(whole.normal_W);
  }
  at_ += static_cast<std::size_t>(at - begin);
  return true;
}

ContactTape::Reader::Facet ContactTape::Reader::pass() noexcept {
  if (at_ == tape_->size_) return {};
  const std::byte* at = tape_->bytes_.get() + at_;
  const Head head = take<Head>(at);
  at_ += bytes_of(head);
  if (head.hold_count == 0) return {};
  const Hold first = take<Hold>(at);
  return {first.surface, first.triangle};
}

}  // namespace fingerpad
