#pragma once

#include "base/types.hpp"

namespace fingerpad {

/// A motion made from a formula. Time starts at 0.
///   line:   from `from_m` to `to_m` at constant speed; duration |to - from|/speed
///   sine:   centre_m + direction * amplitude_m * sin(2 pi frequency_hz t)
///   circle: around `normal` through centre_m at radius_m, frequency_hz turns a second, starting at centre +
///   radius * start
struct ScriptedMotion {
  enum class Kind { line, sine, circle };
  Kind kind = Kind::sine;
  Vec3 from_m = Vec3::Zero(), to_m = Vec3::Zero();
  double speed_m_per_s = 0;
  Vec3 centre_m = Vec3::Zero();
  Vec3 direction = Vec3::UnitX();  ///< unit: along the sine, or from the centre to the circle's start
  Vec3 normal = Vec3::UnitZ();     ///< unit, of the circle's plane; direction is across it
  double amplitude_m = 0;          ///< of the sine; the circle's radius
  double frequency_hz = 0;
  double duration_s = 0;

  Vec3 at(double t_s) const noexcept;
  bool operator==(const ScriptedMotion&) const = default;
};

}  // namespace fingerpad
