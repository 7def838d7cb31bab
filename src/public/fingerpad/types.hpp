#pragma once

#include <Eigen/Core>

namespace fingerpad {

using Vec2 = Eigen::Vector2d;           ///< two numbers
using Vec3 = Eigen::Vector3d;           ///< a point, a direction or a force
using Mat3 = Eigen::Matrix3d;           ///< a rotation
using Points = Eigen::Matrix3Xd;        ///< 3 x n, column i is point i
using IndexTriples = Eigen::Matrix3Xi;  ///< 3 x n, column i is triangle i

}  // namespace fingerpad
