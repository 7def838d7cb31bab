#include "replay/residual_figures.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {
namespace {

/// A shift counts where it leaves less than this share of what is unexplained without.
constexpr double clearly_less = 0.8;

}  // namespace

void ResidualFigures::Shift::add(const Vec3& model, const Vec3& measured) noexcept {
  model_n += model;
  measured_n += measured;
  model_n2 += model.squaredNorm();
  measured_n2 += measured.squaredNorm();
  product_n2 += model.dot(measured);
  ++count;
}

double ResidualFigures::Shift::unexplained() const noexcept {
  constexpr double rounding = 1e-12;  // of a sum of squares: below it a force is constant
  const auto n = static_cast<double>(count);
  const double model_spread = model_n2 - model_n.squaredNorm() / n;
  const double measured_spread = measured_n2 - measured_n.squaredNorm() / n;
  const double common = product_n2 - model_n.dot(measured_n) / n;
  if (!(common > 0 && model_spread > rounding * model_n2 && measured_spread > rounding * measured_n2))
    return 1;
  return std::max(0.0, 1 - common * common / (model_spread * measured_spread));
}

void ResidualFigures::observe(const TickRecord& record) noexcept {
  const Vec3& residual_n = record.residual_W_n;
  squares_n2_ += residual_n.squaredNorm();
  sum_n_ += residual_n;
  if (record.phase == Phase::free) {
    free_sum_n_ += residual_n;
    ++free_ticks_;
  } else {
    const double pressed_n = record.force_W_n.dot(record.normal_W);
    pressed_n_ += pressed_n;
    measured_press_n_ += pressed_n - residual_n.dot(record.normal_W);
  }
  if (ticks_ == 0) first_s_ = record.t_s;
  if (ticks_ == 1) {
    const double tick_s = record.t_s - first_s_;
    stride_ = tick_s > 0 ? std::max(1L, std::lround(least_step_s / tick_s)) : 1;
    step_s_ = tick_s * static_cast<double>(stride_);
  }
  if (ticks_ > 0 && ticks_ % stride_ == 0)
    compare_shifts(record.force_W_n, record.force_W_n - record.residual_W_n);
  ++ticks_;
}

/// Sets the newest of each force against those of the other up to `most_steps` before it.
void ResidualFigures::compare_shifts(const Vec3& model_n, const Vec3& measured_n) noexcept {
  model_n_[steps_ % ring_size] = model_n;
  measured_n_[steps_ % ring_size] = measured_n;
  shifts_[most_steps].add(model_n, measured_n);
  const int before = static_cast<int>(std::min<std::size_t>(steps_, most_steps));
  for (int k = 1; k <= before; ++k) {
    const std::size_t then = (steps_ - static_cast<std::size_t>(k)) % ring_size;
    const int later = most_steps + k, earlier = most_steps - k;
    shifts_[static_cast<std::size_t>(later)].add(model_n_[then], measured_n);
    shifts_[static_cast<std::size_t>(earlier)].add(model_n, measured_n_[then]);
  }
  ++steps_;
}

double ResidualFigures::rms_n() const noexcept {
  return ticks_ > 0 ? std::sqrt(squares_n2_ / static_cast<double>(ticks_)) : TickRecord::nan;
}

double ResidualFigures::scale() const noexcept {
  constexpr double least_n = 0.01;  // on average
  const long touching = ticks_ - free_ticks_;
  if (touching < least_free_ticks || !(pressed_n_ > least_n * static_cast<double>(touching)))
    return TickRecord::nan;
  return measured_press_n_ / pressed_n_;
}

double ResidualFigures::bias_n() const noexcept {
  if (ticks_ == 0) return TickRecord::nan;
  if (free_ticks_ >= least_free_ticks) return free_sum_n_.norm() / static_cast<double>(free_ticks_);
  return sum_n_.norm() / static_cast<double>(ticks_);
}

double ResidualFigures::lag_s() const noexcept {
  constexpr auto least_steps = std::size_t{4} * most_steps;  // so that every shift has most of the run
  if (steps_ < least_steps) return TickRecord::nan;
  int best = 0;
  double least = shifted(0).unexplained();
  const double as_it_is = least;
  for (int k = -most_steps; k <= most_steps; ++k) {
    const double left = shifted(k).unexplained();
    if (left >= least) continue;
    best = k;
    least = left;
  }
  if (!(least < clearly_less * as_it_is)) return 0;
  // A rub to and fro fits again a period on: of what fits as well, the nearest counts.
  const double as_well = least + 0.01 * (as_it_is - least);
  const auto fits = [&](int k) {
    return shifted(k).unexplained() <= as_well && shifted(k).unexplained() <= shifted(k - 1).unexplained() &&
           shifted(k).unexplained() <= shifted(k + 1).unexplained();
  };
  for (int far = 1; far < std::abs(best); ++far) {
    if (!fits(far) && !fits(-far)) continue;
    best = fits(far) ? far : -far;
    least = shifted(best).unexplained();
  }
  if (std::abs(best) == most_steps) return TickRecord::nan;
  // Between the steps, by the parabola through the least one and its neighbours.
  const double before = shifted(best - 1).unexplained(), after = shifted(best + 1).unexplained();
  const double bend = before - 2 * least + after;
  const double part = bend > 0 ? 0.5 * (before - after) / bend : 0;
  return (best + part) * step_s_;
}

}  // namespace fingerpad
