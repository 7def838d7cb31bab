#include "motion/driving_share.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {

double driving_share(const Points& position_W, const Points& force_W, double rate_hz) {
  constexpr double half_window_s = 6e-3;
  const auto half = std::max<Eigen::Index>(1, std::lround(half_window_s * rate_hz));
  double sum = 0, sizes = 0;
  for (Eigen::Index i = half; i + half < position_W.cols(); ++i) {
    const double work = force_W.col(i).dot(position_W.col(i + half) - position_W.col(i - half));
    if (!std::isfinite(work)) continue;
    sum += work;
    sizes += std::abs(work);
  }
  return sizes > 0 ? sum / sizes : 0;
}

}  // namespace fingerpad
