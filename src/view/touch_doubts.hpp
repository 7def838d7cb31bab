#pragma once

#include <string>

#include "touch/tick_record.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// Of a finger that is pressed in farther than the part is thick below the contact: "20 mm deep in 3 mm of
/// part: press less, or stiffen it". Empty of any other, over a plane, and where the way inwards meets no
/// other side, as in an open part.
std::string too_deep_words(const World& world, const TickRecord& row);

/// Whether a finger that just touches a spot would reach well into other surfaces, or into other places of
/// this one: in a hole, a groove or a corner that is too narrow for it. False of a point.
bool is_too_large_for(const World& world, const Vec3& spot_W, const Vec3& normal_W, double radius_m);

}  // namespace fingerpad
