#include "device/workspace.hpp"

#include <Eigen/Geometry>

namespace fingerpad {

Workspace::Workspace(const DeviceSettings& settings, const FingerSample& rest) noexcept
    : settings_(settings), finger_(rest), direction_W_(rest.direction_W) {}

FingerSample Workspace::finger(const DevicePlace& place) noexcept {
  const Vec3 place_W = settings_.offset_m + settings_.scale * in_world(place.p_D);
  const bool held = place.clutch || clutched_;
  clutched_ = place.clutch;
  // The shift follows the device as long as it is clutched, so that the two cancel.
  if (held) shift_W_m_ = finger_.p_WQ - place_W;
  finger_.p_WQ = place_W + shift_W_m_;
  if (place.attitude_D) turn(*place.attitude_D, held);
  return finger_;
}

/// About the world's axes as the device is about its own. What clutching has turned comes first, so that a
/// turn of the device is the same turn of the finger.
void Workspace::turn(const Attitude& attitude_D, bool held) noexcept {
  const Attitude mounted(settings_.rotation);
  const Attitude device_W = (mounted * attitude_D * mounted.conjugate()).normalized();
  if (held) {
    turn_ = (device_W.conjugate() * finger_.attitude.value_or(Attitude::Identity())).normalized();
    return;
  }
  finger_.attitude = (device_W * turn_).normalized();
  finger_.direction_W = (*finger_.attitude * direction_W_).normalized();
}

Vec3 Workspace::force_D_n(const Vec3& force_W_n) const noexcept {
  return settings_.force_scale * in_device(force_W_n);
}

}  // namespace fingerpad
