#include "device/tried_steps.hpp"

#include <algorithm>

#include "device/pointer_limits.hpp"

namespace fingerpad {

using namespace pointer_limits;

bool TriedSteps::go(const Vec3& step_W, double most_n, double dt_s) noexcept {
  const Vec3 to_W = flight_.place_W() + step_W;
  if (foresight_.try_n(to_W, dt_s) > most_n) return false;
  flight_.put(to_W, step_W / dt_s);
  return true;
}

bool TriedSteps::go_shorter(Vec3 step_W, double most_n, double dt_s) noexcept {
  for (int i = 0; i <= most_halvings; ++i, step_W /= 2) {
    if (go(step_W, most_n, dt_s)) return true;
  }
  return false;
}

void TriedSteps::give_way(const TickRecord& touched, double most_n, double at_worst_n, double farthest_m,
                          double dt_s) noexcept {
  // A proxy follows a finger that stays only slowly: mostly that is enough. Where it comes between walls
  // whose forces are together more than one wall's, no short step is.
  const double depth_m = touched.depth_m;
  for (const double share : {0.0, 0.125, 0.25, 0.5, 1.0}) {
    if (go(share * std::min(farthest_m, depth_m) * touched.normal_W, most_n, dt_s)) return;
  }
  double out_m = 2 * farthest_m;
  for (int i = 0; i < most_doublings && out_m < depth_m; ++i, out_m *= 2) {
    if (go(out_m * touched.normal_W, most_n, dt_s)) return;
  }
  if (!go(depth_m * touched.normal_W, at_worst_n, dt_s)) go(Vec3::Zero(), any_force_n, dt_s);
}

}  // namespace fingerpad
