#pragma once

#include <vector>

#include "part/part.hpp"

namespace fingerpad::bench {

/// What a finger does: 0.1 m/s at 1 kHz along a winding path, swaying within 2 mm of the surface on both
/// sides.
std::vector<Vec3> coherent_on_sphere(int count);
std::vector<Vec3> coherent_on_plate(int count);

/// Points anywhere in the part's box, each far from the last; the same ones every time.
std::vector<Vec3> random_in_box(const Part& part, int count);

}  // namespace fingerpad::bench
