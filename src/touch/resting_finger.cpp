#include "touch/resting_finger.hpp"

#include "scene/scene.hpp"
#include "touch/parts_ball.hpp"

namespace fingerpad {

FingerSample resting_finger(const World& world, const Scene& scene) {
  FingerSample finger;
  finger.direction_W = scene.finger.direction;
  constexpr double nothing_m = 0.05;  // as if there were so large a part, where there is nothing
  const std::optional<Ball> parts = ball_of_parts(world);
  if (!parts && !world.surfaces.empty()) {
    constexpr double above_m = 0.01;
    const Surface& plane = world.surfaces.front();
    finger.p_WQ = plane.plane_point_W + plane.plane_normal_W * (above_m + scene.finger.radius_m);
    return finger;
  }
  const Ball ball = parts.value_or(Ball{Vec3::Zero(), nothing_m});
  finger.p_WQ = ball.centre_W + usual_view_W.normalized() * (1.1 * ball.radius_m + scene.finger.radius_m);
  return finger;
}

}  // namespace fingerpad
