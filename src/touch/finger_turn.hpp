#pragma once

#include "fingerpad/finger_sample.hpp"

namespace fingerpad {

/// How the finger has turned from one sample to the next, in W: a rotation vector [rad]. From the attitudes
/// where both samples have one, else the smallest rotation that takes the one direction to the other; zero
/// where either is unusable. noexcept, finite.
Vec3 finger_turn(const FingerSample& from, const FingerSample& to) noexcept;

}  // namespace fingerpad
