#pragma once

#include <optional>

#include "touch/world.hpp"

namespace fingerpad {

/// A ball around points, frame W.
struct Ball {
  Vec3 centre_W = Vec3::Zero();
  double radius_m = 0;
};

/// Around the boxes of all parts of a world; nothing where there is none.
std::optional<Ball> ball_of_parts(const World& world);

/// From where a part is looked at as long as nothing else is known of it; not unit.
inline const Vec3 usual_view_W{0.35, -0.6, 0.72};

}  // namespace fingerpad
