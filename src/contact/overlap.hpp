#pragma once

#include <span>
#include <vector>

#include "contact/placed_surface.hpp"

namespace fingerpad {

/// Two surfaces of a scene, of which one reaches into the other.
struct Overlap {
  std::size_t one = 0, other = 0;  ///< their indices
  double depth_m = 0;              ///< how deep, at least
  Vec3 at_W = Vec3::Zero();        ///< where
};

/// The pairs of parts, and of a part and a plane, that overlap by more than a fiftieth of the smaller part's
/// greatest length: parts that are built to touch, or to sink in a little, do not.
///
/// Looked for at up to 2,000 vertices and 2,000 random places of each part and below these, by their
/// distances behind the other's surface; so what overlaps between these alone is missed. A part that is not
/// closed, or whose facets look inwards, has no inside.
/// @pre parts have their trees
std::vector<Overlap> overlaps(std::span<const PlacedSurface> surfaces);

}  // namespace fingerpad
