#include "study/spring_way.hpp"

#include <cmath>

namespace fingerpad {

double spring_way_m(const TrialEvidence& evidence, const std::array<SpringBend, 2>& bend, const Vec2& forward,
                    double pull) {
  double way_m = 0;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const SpringSums& sums = evidence.spring[k];
    const double share = forward[axis] * forward[axis];
    if (share < 0.01) continue;
    if (!(sums(spring_ratio, spring_ratio) > 0)) return 0;
    way_m += share * sums(spring_position, spring_ratio) / sums(spring_ratio, spring_ratio) * pull *
             bend[k].at(std::abs(pull))[0];
  }
  return way_m;
}

double spring_stiffness_per_m(const TrialEvidence& evidence, const std::array<SpringBend, 2>& bend,
                              const Vec2& forward, double pull) {
  const double step = 0.02 * pull;
  const double way_m =
      spring_way_m(evidence, bend, forward, pull) - spring_way_m(evidence, bend, forward, pull - step);
  return way_m > 0 ? step / way_m : 0;
}

}  // namespace fingerpad
