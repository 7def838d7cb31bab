#include "replay/figures.hpp"

#include <algorithm>
#include <cmath>

#include "replay/summary_column.hpp"

namespace fingerpad {
namespace {

/// Fewer ticks than this in a tooth of the sawtooth and no sampling shows it.
constexpr long ticks_that_show_a_tooth = 2;
/// What the surfaces' springs hold where a run begins in contact [J]: what they give on the straight way from
/// the finger out to where its contact is, on which their force falls evenly to nothing. Several walls push
/// against each other, so that the sum of their normal forces would say more than they can give.
double stored_j(const TickRecord& record) noexcept {
  if (record.phase == Phase::free) return 0;
  return 0.5 * record.depth_m * record.normal_W.dot(record.force_W_n - record.friction_W_n);
}

/// A contact point that goes more than so many times as far as the finger in a tick has jumped.
constexpr double jump_ratio = 4;

}  // namespace

std::span<const std::string_view> Figures::names() noexcept {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const SummaryColumn& column : summary_figure_columns()) all.push_back(column.name);
    return all;
  }();
  return names;
}

double Figures::of(const std::vector<double>& values, std::string_view name) noexcept {
  return values[static_cast<std::size_t>(std::find(names().begin(), names().end(), name) - names().begin())];
}

std::vector<double> Figures::values() const {
  const auto mean = [](double sum, long count) { return count > 0 ? sum / static_cast<double>(count) : 0.0; };
  const auto count = [](long n) { return static_cast<double>(n); };
  return {count(ticks_),
          count(contact_ticks_),
          count(stick_ticks_),
          count(slip_ticks_),
          count(ruptures_),
          count(coarse_teeth_),
          max_depth_m_,
          mean(sum_normal_n_, contact_ticks_),
          max_normal_n_,
          max_friction_n_,
          pressed_slip_ticks_ > 0 ? sum_slip_mu_ / count(pressed_slip_ticks_) : TickRecord::nan,
          max_mu_,
          friction_work_j_,
          count(remedied_ticks_),
          energy_made_j_,
          count(inside_starts_),
          count(pop_throughs_.count()),
          max_step_n_,
          max_step_n_per_m_,
          count(nonfinite_ticks_),
          count(unsettled_ticks_),
          residual_.rms_n(),
          residual_.bias_n(),
          residual_.lag_s()};
}

void Figures::observe_phase(const TickRecord& record) noexcept {
  if (record.phase == Phase::free) {
    has_ruptured_ = false;
    last_phase_ = record.phase;
    return;
  }
  if (ticks_ > 0 && last_phase_ != Phase::free) {
    const double finger_m = (record.p_WQ - last_p_WQ_).norm();
    tooth_crossed_ |= (record.contact_W - last_contact_W_).norm() > jump_ratio * finger_m;
  }
  tooth_crossed_ |= record.walls > 1;  // each has teeth of its own
  last_contact_W_ = record.contact_W;
  stick_ticks_ += record.phase == Phase::stick ? 1 : 0;
  slip_ticks_ += record.phase == Phase::slip ? 1 : 0;
  ++tooth_ticks_;
  if (record.ruptures > 0) {
    // Of several in one tick all but the first of each wall end a tooth that began in it.
    ruptures_ += record.ruptures;
    teeth_ += record.ruptures - (has_ruptured_ ? 0 : 1);
    coarse_teeth_ += std::max(0, record.ruptures - std::max(1, record.walls));
    coarse_teeth_ += has_ruptured_ && tooth_ticks_ < ticks_that_show_a_tooth && !tooth_crossed_ ? 1 : 0;
    has_ruptured_ = true;
    tooth_ticks_ = 0;
    tooth_crossed_ = false;
  }
  last_phase_ = record.phase;
}

void Figures::observe_step(const TickRecord& record) noexcept {
  const Vec3 normal_W_n = record.force_W_n - record.friction_W_n;
  if (ticks_ > 0) {
    max_step_n_ = std::max(max_step_n_, (record.force_W_n - last_force_W_n_).norm());
    const double moved_m = (record.p_WQ - last_p_WQ_).norm();
    // A motion of a few roundings of the position says nothing.
    if (moved_m > 1e-12 * record.p_WQ.norm()) {
      max_step_n_per_m_ = std::max(max_step_n_per_m_, (normal_W_n - last_normal_W_n_).norm() / moved_m);
    }
  }
  last_normal_W_n_ = normal_W_n;
}

void Figures::observe(const TickRecord& record) noexcept {
  observe_phase(record);
  observe_step(record);
  pop_throughs_.observe(record);
  if (record.residual_W_n.allFinite()) residual_.observe(record);
  nonfinite_ticks_ += record.force_W_n.allFinite() ? 0 : 1;
  if (ticks_ > 0) friction_work_j_ += record.friction_W_n.dot(record.p_WQ - last_p_WQ_);
  if (ticks_ > 0) {
    given_j_ += last_force_W_n_.dot(record.p_WQ - last_p_WQ_);
  } else {
    given_j_ = -stored_j(record);
  }
  energy_made_j_ = std::max(energy_made_j_, given_j_);
  last_force_W_n_ = record.force_W_n;
  last_p_WQ_ = record.p_WQ;
  remedied_ticks_ += record.remedied ? 1 : 0;
  inside_starts_ += record.started_inside ? 1 : 0;
  unsettled_ticks_ += record.unsettled ? 1 : 0;
  ++ticks_;
  if (record.phase == Phase::free) return;
  ++contact_ticks_;
  max_depth_m_ = std::max(max_depth_m_, record.depth_m);
  sum_normal_n_ += record.normal_force_n;
  max_normal_n_ = std::max(max_normal_n_, record.normal_force_n);
  max_friction_n_ = std::max(max_friction_n_, record.friction_W_n.norm());
  max_mu_ = std::max(max_mu_, record.mu);
  if (record.phase != Phase::slip || !(record.normal_force_n > 0)) return;
  ++pressed_slip_ticks_;
  sum_slip_mu_ += record.mu;
}

}  // namespace fingerpad
