#pragma once

#include <string>

namespace fingerpad {

/// A closed path in stick: the finger stretches the pad by `stretch_m` across it, load and angle change at
/// rest, and it comes back to where it started.
struct StickCycle {
  std::string law = "stick-slip";
  double stretch_m = 2.7e-4;
  double stretched_n = 1, released_n = 1;
  double stretched_rad = 0.7853981633974483, released_rad = 0.7853981633974483;
};

/// Work of friction on the finger over the cycle [J]: above zero friction has made energy. The law is at its
/// defaults, followed at 100 kHz.
double energy_of_cycle(const StickCycle& cycle);

}  // namespace fingerpad
