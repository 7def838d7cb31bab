#pragma once

#include <string>

#include "friction/law_table.hpp"

namespace fingerpad {

/// A finger of 0.072 kg at rest in stick, held by a hand of 0.5 N s/m and a soft spring of 20 N/m, pushed
/// along the surface by a tenth of the sliding force.
struct StuckFinger {
  std::string law = "stick-slip";
  LawSettings settings = {};
  double rate_hz = 1000;
  double mu_static = 0.3, mu_dynamic = 0.2;
  double inclination_rad = 0.7853981633974483;  ///< of the finger, which points along y
  bool push_along_finger = false;               ///< else across it
};

/// Largest normal force [N] at which the stick phase is quiet: its ringing under the push dies out. Zero
/// where it buzzes at 1 mN, infinite where it does not at 100 N; bisected to 0.5 %.
double quiet_load_n(const StuckFinger& finger);

}  // namespace fingerpad
