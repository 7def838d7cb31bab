#pragma once

#include "base/types.hpp"

namespace fingerpad {

/// Which way forces do work on a finger: the sum of f.dx over that of |f.dx|, dx being the way over 12 ms
/// around each sample. Friction holds a finger back and a pad gives back less than it took, so that forces on
/// the finger come near -1; near 1 their sign is wrong. 0 where nothing moves.
/// @param position_W, force_W  3 x n, of the same moments; samples that are not finite are passed over
double driving_share(const Eigen::Ref<const Points>& position_W, const Eigen::Ref<const Points>& force_W,
                     double rate_hz);

/// The same of each axis by itself: where one alone drives the finger, its force or its position is mirrored.
/// Not a number for an axis that does less than a fifth of the work.
Vec3 driving_share_by_axis(const Eigen::Ref<const Points>& position_W,
                           const Eigen::Ref<const Points>& force_W, double rate_hz);

/// Beyond it forces drive the finger.
inline constexpr double most_driving_share = 0.5;

}  // namespace fingerpad
