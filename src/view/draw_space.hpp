#pragma once

#include <optional>

#include "touch/parts_ball.hpp"
#include "view/view_input.hpp"

namespace fingerpad {

/// The frame that pictures are drawn in: millimetres, axes along W, about an origin near what is shown, so
/// that the graphics' single precision is enough wherever a part lies.
struct DrawSpace {
  Vec3 origin_W = Vec3::Zero();
  Vec3 to_draw(const Vec3& p_W) const { return (p_W - origin_W) * 1e3; }
  Vec3 to_world(const Vec3& p_mm) const { return origin_W + p_mm * 1e-3; }
};

/// What there is to see, and from where.
struct ViewExtent {
  std::optional<Ball> parts;  ///< empty without parts
  std::optional<Ball>
      path;  ///< where the finger touched (or went, where it touched nothing); empty without rows
  Vec3 facing_W = usual_view_W;  ///< the mean contact normal, or towards a good view of a part
  double max_force_n = 0;        ///< the largest force on the finger

  /// The whole of it; a ball of 50 mm where there is nothing.
  Ball everything() const;
};

ViewExtent extent_of(const ViewInput& input);

}  // namespace fingerpad
