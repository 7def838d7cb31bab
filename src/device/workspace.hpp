#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "motion/finger_path.hpp"
#include "scene/device_settings.hpp"

namespace fingerpad {

/// Where a device says that it is, in its own space.
struct DevicePlace {
  Vec3 p_D = Vec3::Zero();               ///< [m]
  std::optional<Attitude> attitude_D{};  ///< unit; the unit turn is a finger that lies as the scene says
  bool clutch = false;                   ///< the hand moves the device, and the finger stays
};

/// How a device's space lies in the world: p_WQ = p_WD + scale R_WD p_D, and what clutching adds to it.
/// While the clutch is held the finger stays, and stays turned as it is; when it is let go, the finger goes
/// on from there, in place and turn.
class Workspace {
 public:
  /// @param rest  how the finger lies while the device has said nothing of it
  Workspace(const DeviceSettings& settings, const FingerSample& rest) noexcept;

  /// The finger of a device that is there.
  FingerSample finger(const DevicePlace& place) noexcept;
  /// A force in the world as the device is to show it, and back without the scale.
  Vec3 force_D_n(const Vec3& force_W_n) const noexcept;
  Vec3 in_world(const Vec3& vector_D) const noexcept { return settings_.rotation * vector_D; }
  Vec3 in_device(const Vec3& vector_W) const noexcept { return settings_.rotation.transpose() * vector_W; }
  double scale() const noexcept { return settings_.scale; }

 private:
  void turn(const Attitude& attitude_D, bool held) noexcept;

  DeviceSettings settings_;
  FingerSample finger_;
  Vec3 direction_W_;               ///< of a finger whose device is not turned
  Vec3 shift_W_m_ = Vec3::Zero();  ///< by all clutching so far
  Attitude turn_ =
      Attitude::Identity();  ///< of the finger in a device that is not turned, by all clutching so far
  bool clutched_ = false;
};

}  // namespace fingerpad
