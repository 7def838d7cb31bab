#pragma once

#include <string>

#include "study/profile_fit.hpp"

namespace fingerpad {

/// What a force sensor's zero that is not known may do. What it is off by along the plate's normal and
/// friction that changes with the load look alike: of forces that are told n + o where n presses, friction mu
/// n^(1+e) has the exponent e' with 1 + e' = (1 + e) (n + o)/n, and mu is (n + o)/n times what is told.
///
/// Friction that hardly changes with the load is taken to be so, and no offset beyond that to be there.
/// Else either may be behind it, as far as fingers have exponents of -1/3 to 0. Where nothing tells how
/// friction changes, the offset is taken to be up to three times as large as one along the plate (of two of
/// its components one is seen), and up to two tenths of a newton at the least, as a sensor's channel that is
/// right says nothing of another's zero.
struct ZeroDoubt {
  double untared_share = 0;    ///< of the trials, that no tare was taken off
  double least = 1, most = 1;  ///< what coefficients may have to be multiplied by
  bool is_likely = false;      ///< something speaks for an offset
  bool is_seen = false;        ///< beyond chance
  std::string words;           ///< why; empty: all is known
};

/// @param knows_zero  the user said that the sensor was zeroed
ZeroDoubt zero_doubt(const ProfileFit& fit, bool knows_zero);

/// Widens the intervals of what rests on the force's zero by what an offset may do to it; refuses what one
/// that is seen to be likely may change by more than a fifth, and the normal law where it has no interval
/// that could allow for that. Axes rest on the offset along the plate alone.
void doubt_zero(const ZeroDoubt& doubt, ProfileFit& fit);

}  // namespace fingerpad
