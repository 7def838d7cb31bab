#pragma once

#include <limits>

#include "motion/finger_path.hpp"
#include "part/bounds.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// Where a motion comes nearest to what there is to touch, or goes deepest into it.
struct NearestApproach {
  double gap_m = std::numeric_limits<double>::infinity();  ///< of the finger's skin; below 0 within a surface
  double between_m = 0;  ///< between the places looked at the finger may come nearer by so much
  double t_s = 0;
  std::size_t surface = 0;
  Bounds box_W;  ///< of all places looked at [m]
};

/// Of a motion of a million ticks at most every one is looked at; a second or two.
inline constexpr long most_approach_places = 1000000;

/// @param columns      how the path's coordinates are taken: a row an axis
/// @param most_places  of a path of more ticks, every so many-th and its last
NearestApproach nearest_approach(const World& world, const FingerPath& path, double radius_m,
                                 const Mat3& columns = Mat3::Identity(),
                                 long most_places = most_approach_places);

}  // namespace fingerpad
