#include "study/sampling_reach.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "study/rupture_sums.hpp"
#include "study/slope_window.hpp"
#include "study/unseen_slip.hpp"

namespace fingerpad {
namespace {

constexpr PadNumber reach_axes[] = {PadNumber::lateral_axis, PadNumber::longitudinal_axis},
                    reach_stiffnesses[] = {PadNumber::stick_stiffness, PadNumber::longitudinal_stiffness},
                    reach_shares[] = {PadNumber::lateral_cubic_share, PadNumber::longitudinal_cubic_share};

/// How far coefficients may be off where stick hides: slip may hold teeth, whose mean is half way up to
/// mu_static, and of ruptures that noise hides half the time those are seen that noise raises.
struct HiddenReach {
  double mu_static = 0, mu_dynamic = 0;
};

HiddenReach hidden_reach(const ProfileFit& fit, const FitPoint& point) {
  const auto value = [&](PadNumber number) -> const PadValue& { return value_of(fit.values, number); };
  const PadValue &mu_static = value(PadNumber::mu_static), &mu_dynamic = value(PadNumber::mu_dynamic);
  HiddenReach reach;
  const bool is_likely = point.has_unseen_slip || point.evidence.hidden_stick_ratio > 0;
  if (!is_likely || !mu_dynamic.refusal.empty()) return reach;
  const double unseen = unseen_drop_share(fit.evidence) * mu_dynamic.value,
               drop = mu_static.value - mu_dynamic.value;
  if (mu_static.refusal.empty() && drop < 1.5 * unseen)
    reach.mu_static = 0.3 * (std::max(0.0, unseen - drop) + unseen / 6);
  const bool may_hold_teeth =
      point.has_unseen_slip || !mu_static.refusal.empty() || slip_may_hold_teeth(fit.evidence, fit.values);
  if (!may_hold_teeth || (!point.has_unseen_slip && value(PadNumber::v_min).refusal.empty())) return reach;
  double seen = 0, teeth = 0;
  for (const TrialEvidence& trial : fit.evidence) {
    seen += trial.short_drop;
    teeth += static_cast<double>(trial.short_teeth);
  }
  reach.mu_dynamic = std::max(unseen / 2, teeth > 0 ? seen / teeth : 0);
  if (mu_static.refusal.empty() && (point.has_unseen_slip || mu_static.samples > 10))
    reach.mu_dynamic = std::max(unseen / 2, drop);
  return reach;
}

double greatest_rate_hz(const std::vector<TrialEvidence>& trials) {
  double rate_hz = 0;
  for (const TrialEvidence& trial : trials) rate_hz = std::max(rate_hz, trial.rate_hz);
  return rate_hz;
}

/// How many samples a tooth of stick and slip takes at v_min, from mu_dynamic to mu_static along the spring;
/// nothing where that is not known.
std::optional<double> tooth_samples(const ProfileFit& fit, const EvidencePoint& about) {
  const auto value = [&](PadNumber number) -> const PadValue& { return value_of(fit.values, number); };
  const PadValue &mu_static = value(PadNumber::mu_static), &mu_dynamic = value(PadNumber::mu_dynamic),
                 &v_min = value(PadNumber::v_min);
  if (!mu_static.refusal.empty() || !mu_dynamic.refusal.empty() || !v_min.refusal.empty())
    return std::nullopt;
  double way_m = 0, told = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!value(reach_axes[axis]).refusal.empty()) continue;
    const auto way = [&](double ratio) { return about.bend[axis].at(ratio)[0] * ratio; };
    way_m += value(reach_axes[axis]).value * (1 - way(mu_dynamic.value) / way(mu_static.value));
    ++told;
  }
  if (told == 0) return std::nullopt;
  return way_m / told / v_min.value * greatest_rate_hz(fit.evidence);
}

/// A tooth that is seen for certain: six samples, and as long as half a window of stick_segments, which grows
/// until a finger at v_min has moved beyond the noise of positions in it. The end of slip may be seen a tooth
/// late where teeth are shorter, and where a slow sensor's drop takes much of them.
double long_tooth_samples(const ProfileFit& fit, const FitPoint& point) {
  constexpr double fewest = 6;
  const double speed = value_of(fit.values, PadNumber::v_min).value;
  double half_s = slope_half_window_s;
  for (const TrialEvidence& trial : fit.evidence)  // a line's spread is its length squared over twelve
    if (speed > 0)
      half_s =
          std::max(half_s, std::sqrt(2 * 12.0) * least_window_spread * trial.position_noise_m / speed / 2);
  return static_cast<double>(point.evidence.drop_tail) +
         std::max(fewest, half_s * greatest_rate_hz(fit.evidence));
}

/// What lines that are left in may add to the force ratio at ruptures, which come early where they pull: the
/// mean of their amplitudes over what the trials press.
double reach_by_lines(const std::vector<TrialEvidence>& trials) {
  double sum = 0, ruptures = 0;
  for (const TrialEvidence& trial : trials) {
    if (trial.ruptures == 0) continue;
    const auto own = static_cast<double>(trial.ruptures);
    for (const LineLeftIn& line : trial.lines_left_in)
      sum += own * line.amplitude_n / std::exp(trial.rupture_log_load / own);
    ruptures += own;
  }
  return ruptures > 0 ? sum / ruptures : 0;
}

/// How far springs may be off by ends of slip that pass for stick, and bent ones by being told from weak
/// pulls alone, where stick may hide: their ends lie beyond.
void add_bend_reach(const ProfileFit& fit, const EvidencePoint& about, NumberReaches& moved) {
  constexpr double bends = 1e-3, of_share = 0.08;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double bent = bends + (about.hidden_stick_ratio > 0 ? of_share * about.bend[axis].cubic_share : 0);
    moved[static_cast<std::size_t>(reach_shares[axis])] += bent;
    for (const PadNumber number : {reach_axes[axis], reach_stiffnesses[axis]}) {
      const auto k = static_cast<std::size_t>(number);
      moved[k] += bent / 2 * std::abs(fit.values[k].value);
    }
  }
}

}  // namespace

double unseen_drop_share(const std::vector<TrialEvidence>& trials) {
  double drop = 0, friction = 0;
  for (const TrialEvidence& trial : trials) {
    drop += static_cast<double>(trial.slip_samples) * trial.unseen_drop;
    friction += trial.slip_ratio;
  }
  return friction > 0 ? drop / friction : 0;
}

double teeth_reach(const ProfileFit& fit, const FitPoint& point) {
  return hidden_reach(fit, point).mu_dynamic;
}

NumberReaches moved_by(const std::vector<TrialEvidence>& evidence, const ProfileFit& fit,
                       const FitPoint& point) {
  const PadValues values = pad_numbers(evidence, std::vector<int>(evidence.size(), 1), point);
  NumberReaches moved{};
  for (std::size_t k = 0; k < moved.size(); ++k) {
    if (fit.values[k].refusal.empty() && values[k].refusal.empty())
      moved[k] = std::abs(values[k].value - fit.values[k].value);
  }
  return moved;
}

void DelayReach::add(const std::vector<TrialEvidence>& delayed, const ProfileFit& fit,
                     const FitPoint& point) {
  const PadValues values = pad_numbers(delayed, std::vector<int>(delayed.size(), 1), point);
  for (std::size_t k = 0; k < moved.size(); ++k) {
    if (!fit.values[k].refusal.empty()) continue;
    if (values[k].refusal.empty()) {
      moved[k] = std::max(moved[k], std::abs(values[k].value - fit.values[k].value));
    } else {
      is_lost[k] = true;
    }
  }
}

NumberReaches moved_by_sampling(const ProfileFit& fit, const NumberReaches& by_delay, const FitPoint& point,
                                bool has_slow_slip) {
  constexpr double unsure = 0.1, beside = 0.025;
  // And what drops seem to be late: where it is taken out, that is unsure by about as much, for of a slow
  // drop only the beginning is seen.
  const double later = 0.05 + seen_rupture_lag(fit.evidence);
  const double long_tooth = long_tooth_samples(fit, point);
  const double earlier =
      0.5 + std::max(0.0, long_tooth - tooth_samples(fit, point.evidence).value_or(long_tooth));
  const double bent = (point.evidence.bend[0].cubic_share + point.evidence.bend[1].cubic_share) / 2;
  std::vector<TrialEvidence> noisier = fit.evidence;
  for (TrialEvidence& trial : noisier) {
    for (std::size_t axis = 0; axis < 2; ++axis) trial.spring[axis] -= unsure * trial.spring_noise[axis];
    trial.rupture_ratio += later * (1 + bent) * trial.rupture_rise;
    trial.stop_speed_m_per_s += earlier * trial.stop_slowing_m_per_s;
  }
  NumberReaches moved = moved_by(noisier, fit, point);
  for (std::size_t k = 0; k < moved.size(); ++k) moved[k] += by_delay[k];
  // Where stick passes for slip before slip is seen to end, it does so within mu_dynamic too.
  if (!value_of(fit.values, PadNumber::v_min).refusal.empty()) {
    double rise = 0;
    long stops = 0;
    for (const TrialEvidence& trial : fit.evidence) rise += trial.stop_rise, stops += trial.stops;
    if (stops > 0)
      moved[static_cast<std::size_t>(PadNumber::mu_dynamic)] +=
          std::max(0.0, rise / static_cast<double>(stops));
  }
  if (point.v_min_by_step) {
    const auto k = static_cast<std::size_t>(PadNumber::v_min);
    moved[k] = SlipBySpeed::bin_width * fit.values[k].value + by_delay[k];
  }
  moved[static_cast<std::size_t>(PadNumber::mu_static)] += reach_by_lines(fit.evidence);
  const HiddenReach hidden = hidden_reach(fit, point);
  moved[static_cast<std::size_t>(PadNumber::mu_static)] += hidden.mu_static;
  moved[static_cast<std::size_t>(PadNumber::mu_dynamic)] += hidden.mu_dynamic;
  add_bend_reach(fit, point.evidence, moved);
  constexpr double slow_share = 5e-4;  // of slip's friction: what slow slip is left in it
  const auto dynamic = static_cast<std::size_t>(PadNumber::mu_dynamic);
  moved[dynamic] += (has_slow_slip ? 2 : 1) * slow_share * std::abs(fit.values[dynamic].value);
  if (point.vibration) {
    const double step_hz =
        point.vibration->rate_hz / static_cast<double>(vibration_window(point.vibration->rate_hz));
    moved[static_cast<std::size_t>(PadNumber::vibration)] += beside * step_hz;
    moved[static_cast<std::size_t>(PadNumber::vibration_bandwidth)] += beside * step_hz;
  }
  return moved;
}

}  // namespace fingerpad
