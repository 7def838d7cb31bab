#include "device/workspace.hpp"

#include <Eigen/Geometry>

namespace fingerpad {

Workspace::Workspace(const DeviceSettings& settings, const FingerSample& rest) noexcept
    : settings_(settings), finger_(rest), direction_W_(rest.direction_W) {}

FingerSample Workspace::finger(const DevicePlace& place) noexcept {
  const Vec3 place_W = settings_.offset_m + settings_.scale * in_world(place.p_D);
  // The shift follows the device as long as it is clutched, so that the two cancel.
  if (place.clutch || clutched_) shift_W_m_ = finger_.p_WQ - place_W;
  clutched_ = place.clutch;
  finger_.p_WQ = place_W + shift_W_m_;
  if (place.attitude_D && !place.clutch) {
    // Turned about the world's axes as the device is about its own.
    const Attitude mounted(settings_.rotation);
    finger_.attitude = (mounted * *place.attitude_D * mounted.conjugate()).normalized();
    finger_.direction_W = (*finger_.attitude * direction_W_).normalized();
  }
  return finger_;
}

Vec3 Workspace::force_D_n(const Vec3& force_W_n) const noexcept {
  return settings_.force_scale * in_device(force_W_n);
}

}  // namespace fingerpad
