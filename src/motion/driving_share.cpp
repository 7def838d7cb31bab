#include "motion/driving_share.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fingerpad {

namespace {

/// Tells what the force does along each axis over 12 ms around each sample [J].
template <typename Tell>
void each_work(const Eigen::Ref<const Points>& position_W, const Eigen::Ref<const Points>& force_W,
               double rate_hz, const Tell& tell) {
  constexpr double half_window_s = 6e-3;
  const auto half = std::max<Eigen::Index>(1, std::lround(half_window_s * rate_hz));
  for (Eigen::Index i = half; i + half < position_W.cols(); ++i) {
    const Vec3 work = force_W.col(i).cwiseProduct(position_W.col(i + half) - position_W.col(i - half));
    if (work.allFinite()) tell(work);
  }
}

}  // namespace

double driving_share(const Eigen::Ref<const Points>& position_W, const Eigen::Ref<const Points>& force_W,
                     double rate_hz) {
  double sum = 0, sizes = 0;
  each_work(position_W, force_W, rate_hz, [&](const Vec3& work) {
    sum += work.sum();
    sizes += std::abs(work.sum());
  });
  return sizes > 0 ? sum / sizes : 0;
}

Vec3 driving_share_by_axis(const Eigen::Ref<const Points>& position_W,
                           const Eigen::Ref<const Points>& force_W, double rate_hz) {
  constexpr double least_part = 0.2;
  Vec3 sum = Vec3::Zero(), sizes = Vec3::Zero();
  each_work(position_W, force_W, rate_hz, [&](const Vec3& work) {
    sum += work;
    sizes += work.cwiseAbs();
  });
  const double least = std::max(least_part * sizes.sum(), std::numeric_limits<double>::min());
  return (sizes.array() >= least).select(sum.cwiseQuotient(sizes), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace fingerpad
