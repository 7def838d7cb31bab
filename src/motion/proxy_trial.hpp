#pragma once

#include <vector>

#include "base/types.hpp"

namespace fingerpad {

class TriangleTree;

/// How far a proxy of the finger's radius is left behind at most, as the finger's centre goes through these
/// places of a part's frame: how deep it is pressed in, by whatever wall the proxy stands at [m].
double deepest_press_m(const TriangleTree& tree, const std::vector<Vec3>& centres_P, double radius_m);

}  // namespace fingerpad
