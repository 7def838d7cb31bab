#include "view/arrow_scale.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {
namespace {

/// Long enough that arrows of a rubbing finger keep one scale, short enough to wait for.
constexpr double recovery_s = 2;
/// No arrow of a touch that is lighter is made longer: it would be noise.
constexpr double least_n = 0.05;

double decayed(double force_n, double elapsed_s) {
  return force_n * std::exp(-std::max(0.0, elapsed_s) / recovery_s);
}

/// What nine of ten ticks in contact stay below.
double usual_of(std::span<const TickRecord> rows) {
  std::vector<double> forces_n;
  for (const TickRecord& row : rows) {
    if (row.phase != Phase::free) forces_n.push_back(row.force_W_n.norm());
  }
  if (forces_n.empty()) return 1;
  const auto ninth = forces_n.begin() + static_cast<std::ptrdiff_t>(9 * (forces_n.size() - 1) / 10);
  std::nth_element(forces_n.begin(), ninth, forces_n.end());
  return std::max(least_n, *ninth);
}

}  // namespace

ArrowScale::ArrowScale(std::span<const TickRecord> rows) : rows_(rows) {
  if (rows.empty()) return;
  usual_n_ = force_n_ = usual_of(rows);
  double held_n = 0, last_s = rows.front().t_s;
  scale_n_.reserve(rows.size());
  for (const TickRecord& row : rows) {
    held_n = std::max(row.force_W_n.norm(), decayed(held_n, row.t_s - last_s));
    last_s = row.t_s;
    scale_n_.push_back(std::max(usual_n_, held_n));
  }
}

void ArrowScale::see(const TickRecord& row) noexcept {
  if (!scale_n_.empty()) {
    const auto after = std::upper_bound(rows_.begin(), rows_.end(), row.t_s,
                                        [](double t_s, const TickRecord& other) { return t_s < other.t_s; });
    const auto index = std::max<std::ptrdiff_t>(0, after - rows_.begin() - 1);
    force_n_ = scale_n_[static_cast<std::size_t>(index)];
    return;
  }
  const double now_n = row.force_W_n.norm();
  const double held_n = force_n_ > usual_n_ ? decayed(force_n_, row.t_s - last_s_) : 0;
  force_n_ = std::max({usual_n_, std::isfinite(now_n) ? now_n : 0.0, held_n});
  last_s_ = row.t_s;
}

}  // namespace fingerpad
