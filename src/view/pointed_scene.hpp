#pragma once

#include <limits>
#include <vector>

#include "view/drawing.hpp"

namespace fingerpad {

/// Lines of sight of a view without perspective: draw space [mm], a pixel's is at a corner's and so many
/// steps on.
struct SightLines {
  Vec3 near_mm = Vec3::Zero(), far_mm = Vec3::Zero();  ///< of the pixel (0, 0)
  Vec3 right_mm = Vec3::Zero(), up_mm = Vec3::Zero();  ///< a pixel on
};

/// What a window shows, as far as it matters to one who points at it.
struct PointedScene {
  Box scene;                ///< where there is something to touch
  std::vector<Box> panels;  ///< over it
  SightLines lines;
  Vec3 towards_eye_W = Vec3::UnitZ();
  Vec3 finger_W = Vec3::Constant(std::numeric_limits<double>::infinity());  ///< where it was last; else far
};

}  // namespace fingerpad
