#pragma once

#include "motion/finger_path.hpp"

namespace fingerpad {

/// What a pointer asks for, and from where the one who points looks.
struct PointerAim {
  FingerSample finger;  ///< t_s: of the event, on any clock; push_W_n: what to press with, zero to hover
  Vec3 towards_eye_W = Vec3::UnitZ();
  Vec3 spot_W = Vec3::Zero();  ///< of the surface, where it is to be pressed; else the finger's place

  bool presses() const noexcept { return finger.push_W_n != Vec3::Zero(); }
  /// Takes over what an event asks for. The spot is then the finger's place.
  /// @returns false where that is no finite place, push and direction: nothing is taken over then
  bool ask(const FingerSample& target) noexcept;
  /// A direction of any length; one that is none changes nothing.
  void look_from(const Vec3& towards_W) noexcept;
};

}  // namespace fingerpad
