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
  std::vector<double> values;
  values.reserve(names().size());
  for (const SummaryColumn& column : summary_figure_columns()) values.push_back(column.get(totals_));
  return values;
}

void Figures::observe_phase(const TickRecord& record) noexcept {
  if (record.phase == Phase::free) {
    has_ruptured_ = false;
    last_phase_ = record.phase;
    return;
  }
  if (totals_.ticks > 0 && last_phase_ != Phase::free) {
    const double finger_m = (record.p_WQ - last_p_WQ_).norm();
    tooth_crossed_ |= (record.contact_W - last_contact_W_).norm() > jump_ratio * finger_m;
  }
  tooth_crossed_ |= record.walls > 1;  // each has teeth of its own
  last_contact_W_ = record.contact_W;
  totals_.stick_ticks += record.phase == Phase::stick ? 1 : 0;
  totals_.slip_ticks += record.phase == Phase::slip ? 1 : 0;
  ++tooth_ticks_;
  if (record.ruptures > 0) {
    // Of several in one tick all but the first of each wall end a tooth that began in it.
    totals_.ruptures += record.ruptures;
    totals_.teeth += record.ruptures - (has_ruptured_ ? 0 : 1);
    totals_.coarse_teeth += std::max(0, record.ruptures - std::max(1, record.walls));
    totals_.coarse_teeth +=
        has_ruptured_ && tooth_ticks_ < ticks_that_show_a_tooth && !tooth_crossed_ ? 1 : 0;
    has_ruptured_ = true;
    tooth_ticks_ = 0;
    tooth_crossed_ = false;
  }
  last_phase_ = record.phase;
}

void Figures::observe_step(const TickRecord& record) noexcept {
  const Vec3 normal_W_n = record.force_W_n - record.friction_W_n;
  if (totals_.ticks > 0) {
    totals_.max_step_n = std::max(totals_.max_step_n, (record.force_W_n - last_force_W_n_).norm());
    const double moved_m = (record.p_WQ - last_p_WQ_).norm();
    // A motion of a few roundings of the position says nothing.
    if (moved_m > 1e-12 * record.p_WQ.norm()) {
      totals_.max_step_n_per_m =
          std::max(totals_.max_step_n_per_m, (normal_W_n - last_normal_W_n_).norm() / moved_m);
    }
  }
  last_normal_W_n_ = normal_W_n;
}

/// A tick's force and torque are held until the next, as a device holds what it was sent.
void Figures::observe_work(const TickRecord& record) noexcept {
  if (totals_.ticks > 0) {
    const Vec3 moved_m = record.p_WQ - last_p_WQ_;
    const double turned_j = last_torque_W_n_m_.dot(record.turn_W);
    totals_.friction_work_j += last_friction_W_n_.dot(moved_m) + turned_j;
    given_j_ += last_force_W_n_.dot(moved_m) + turned_j;
  } else {
    given_j_ = -stored_j(record);
  }
  totals_.energy_made_j = std::max(totals_.energy_made_j, given_j_);
  last_force_W_n_ = record.force_W_n;
  last_friction_W_n_ = record.friction_W_n;
  last_torque_W_n_m_ = record.torque_W_n_m;
  last_p_WQ_ = record.p_WQ;
}

void Figures::observe(const TickRecord& record) noexcept {
  observe_phase(record);
  observe_step(record);
  totals_.pop_throughs.observe(record);
  if (record.residual_W_n.allFinite()) totals_.residual.observe(record);
  totals_.nonfinite_ticks += record.force_W_n.allFinite() ? 0 : 1;
  observe_work(record);
  totals_.remedied_ticks += record.remedied ? 1 : 0;
  totals_.inside_starts += record.started_inside ? 1 : 0;
  totals_.unsettled_ticks += record.unsettled ? 1 : 0;
  ++totals_.ticks;
  if (record.phase == Phase::free) return;
  ++totals_.contact_ticks;
  totals_.max_depth_m = std::max(totals_.max_depth_m, record.depth_m);
  totals_.sum_normal_n += record.normal_force_n;
  totals_.max_normal_n = std::max(totals_.max_normal_n, record.normal_force_n);
  totals_.max_friction_n = std::max(totals_.max_friction_n, record.friction_W_n.norm());
  totals_.max_mu = std::max(totals_.max_mu, record.mu);
  if (record.phase != Phase::slip || !(record.normal_force_n > 0)) return;
  ++totals_.pressed_slip_ticks;
  totals_.sum_slip_mu += record.mu;
}

}  // namespace fingerpad
