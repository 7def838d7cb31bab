#pragma once

#include <string>
#include <vector>

#include "part/part.hpp"

namespace fingerpad::bench {

/// A finger's way through a part, a place a tick of 1 ms, frame P.
struct TickWalk {
  std::string name;
  std::vector<Vec3> places;
};

/// What fingers do to a part, the same ones every time: `rub` presses along its surface at some 0.1 m/s,
/// with a tremble; `strike` is shot through it from all sides at up to 5 m/s; `jump` is put somewhere else
/// every eight ticks, and trembles there.
/// @param radius_m  of the finger's ball, which is pressed in by a fifth of a millimetre
std::vector<TickWalk> tick_walks(const Part& part, double radius_m, int ticks);

}  // namespace fingerpad::bench
