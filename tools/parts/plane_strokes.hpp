#pragma once

#include "rub.hpp"

namespace fingerpad::parts {

/// The motion of the paper's figure 12: a point finger strokes back and forth along y on the plane z = 0, at
/// about two strokes a second and 4 to 5.5 cm to either side, and presses 2 to 4 mm deep. The hand's rhythm,
/// reach and pressure drift slowly; it comes from above at the start and leaves at the end. Directions are
/// left zero: the scene gives one.
std::vector<RubSample> plane_strokes(double rate_hz);

}  // namespace fingerpad::parts
