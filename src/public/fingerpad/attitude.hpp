#pragma once

#include <Eigen/Geometry>

namespace fingerpad {

/// How a body is turned: a unit quaternion that takes the body's axes to the world's. Stored anywhere, so not
/// aligned.
using Attitude = Eigen::Quaternion<double, Eigen::DontAlign>;

}  // namespace fingerpad
