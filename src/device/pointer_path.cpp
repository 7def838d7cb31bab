#include "device/pointer_path.hpp"

#include <algorithm>

namespace fingerpad {
namespace {

/// A pointer that rested longer than this between two events set out just before the second.
constexpr double long_rest_s = 0.1, setting_out_s = 0.016;
/// So far behind the newest event the path is played faster: a hand that lags more feels like a rope.
constexpr double most_lag_s = 0.15, hurry = 2;
/// So far behind it events are not late: their clock has leapt.
constexpr double leap_s = 1;

}  // namespace

void PointerPath::put(const PointerAim& aim) noexcept {
  const std::size_t put = put_.load(std::memory_order_relaxed);
  const std::size_t room = capacity - (put - taken_.load(std::memory_order_acquire));
  const bool begins = aim.presses() && !pressed_, ends = !aim.presses() && pressed_;
  if (room < (ends ? 1 : begins ? 2 : 3)) return;
  pressed_ = aim.presses();
  ring_[put % capacity] = aim;
  put_.store(put + 1, std::memory_order_release);
}

const PointerAim* PointerPath::next() const noexcept {
  const std::size_t taken = taken_.load(std::memory_order_relaxed);
  return taken == put_.load(std::memory_order_acquire) ? nullptr : &ring_[taken % capacity];
}

/// Between the last event and the one that comes. A press stays where it is until the event that ends it,
/// which is a place above the surface.
void PointerPath::show(const PointerAim& to) noexcept {
  const double span_s = to.finger.t_s - from_.finger.t_s;
  const double share = span_s > 0 ? std::clamp((now_s_ - from_.finger.t_s) / span_s, 0.0, 1.0) : 1.0;
  shown_ = from_;
  if (from_.presses() && !to.presses()) return;
  shown_.finger.p_WQ += share * (to.finger.p_WQ - from_.finger.p_WQ);
  shown_.spot_W += share * (to.spot_W - from_.spot_W);
}

const PointerAim& PointerPath::advance(double dt_s) noexcept {
  const std::size_t put = put_.load(std::memory_order_acquire);
  const std::size_t waiting = put - taken_.load(std::memory_order_relaxed);
  if (waiting == 0) {  // the pointer rests, or its events are late
    shown_ = from_;
    rested_ = true;
    return shown_;
  }
  const double newest_s = ring_[(put - 1) % capacity].finger.t_s;
  now_s_ += dt_s * (newest_s - now_s_ > most_lag_s ? hurry : 1);
  if (newest_s - now_s_ > leap_s) now_s_ = newest_s - most_lag_s;
  for (const PointerAim* to = next(); to != nullptr; to = next()) {
    if (!started_ || (rested_ && to->finger.t_s - now_s_ > long_rest_s)) {
      now_s_ = to->finger.t_s - setting_out_s;
      from_.finger.t_s = now_s_;
    }
    started_ = true;
    rested_ = false;
    if (to->finger.t_s > now_s_) {
      show(*to);
      return shown_;
    }
    const bool begins_or_ends = to->presses() != from_.presses();
    from_ = *to;
    taken_.store(taken_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
    if (begins_or_ends) break;  // a press is shown, and so is that it has ended, however soon the next comes
  }
  now_s_ = from_.finger.t_s;  // the next is taken up from here
  shown_ = from_;
  rested_ = next() == nullptr;
  return shown_;
}

}  // namespace fingerpad
