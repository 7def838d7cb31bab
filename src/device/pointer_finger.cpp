#include "device/pointer_finger.hpp"

#include <cmath>
#include <numbers>

#include "device/device_table.hpp"

namespace fingerpad {
namespace {

/// Follows a mouse closely, yet smooths a screen's 60 positions a second.
constexpr double pointer_bandwidth_hz = 8;

}  // namespace

PointerFinger::PointerFinger(const FingerSample& start, double bandwidth_hz)
    : omega_(2 * std::numbers::pi * bandwidth_hz), target_(start), seen_target_(start), finger_(start) {}

void PointerFinger::set_target(const FingerSample& target) {
  const std::lock_guard lock(mutex_);
  target_ = target;
}

FingerSample PointerFinger::advance(double dt_s) {
  {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock.owns_lock()) seen_target_ = target_;
  }
  // The closed form of the critically damped follower over dt, the target held.
  const double decay = std::exp(-omega_ * dt_s);
  const Vec3 offset = finger_.p_WQ - seen_target_.p_WQ;
  const Vec3 slope = velocity_m_per_s_ + omega_ * offset;
  finger_.p_WQ = seen_target_.p_WQ + (offset + slope * dt_s) * decay;
  velocity_m_per_s_ = (velocity_m_per_s_ - omega_ * slope * dt_s) * decay;
  const Vec3 direction = finger_.direction_W * decay + seen_target_.direction_W * (1 - decay);
  if (direction.norm() > 1e-6) finger_.direction_W = direction.normalized();
  return finger_;
}

DeviceEntry pointer_device() noexcept {
  return {.name = "pointer",
          .doc = "the mouse and the keyboard, in the window",
          .make = [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<PointerFinger>(setup.start, pointer_bandwidth_hz);
          },
          .needs_window = true};
}

}  // namespace fingerpad
