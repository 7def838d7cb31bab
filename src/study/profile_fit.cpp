#include "study/profile_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/number_text.hpp"
#include "base/random_stream.hpp"
#include "scene/toml_tree.hpp"
#include "study/hidden_stick.hpp"

namespace fingerpad {
namespace {

constexpr int bootstrap_draws = 400;

/// The mean share of friction that a rupture may drop unseen.
double unseen_drop_share(const std::vector<TrialEvidence>& trials) {
  double drop = 0, friction = 0;
  for (const TrialEvidence& trial : trials) {
    drop += static_cast<double>(trial.slip_samples) * trial.unseen_drop;
    friction += trial.slip_ratio;
  }
  return friction > 0 ? drop / friction : 0;
}

/// How far coefficients may be off where stick hides: slip may hold teeth, whose mean is half way up to
/// mu_static, and of ruptures that noise hides half the time those are seen that noise raises.
struct HiddenReach {
  double mu_static = 0, mu_dynamic = 0;
};

HiddenReach hidden_reach(const ProfileFit& fit, const FitPoint& point) {
  const auto value = [&](PadNumber number) -> const PadValue& {
    return fit.values[static_cast<std::size_t>(number)];
  };
  const PadValue &mu_static = value(PadNumber::mu_static), &mu_dynamic = value(PadNumber::mu_dynamic);
  HiddenReach reach;
  const bool is_likely = point.evidence.hidden_stick_ratio > 0;
  if (!is_likely || !mu_dynamic.refusal.empty()) return reach;
  const double unseen = unseen_drop_share(fit.evidence) * mu_dynamic.value,
               drop = mu_static.value - mu_dynamic.value;
  if (mu_static.refusal.empty() && drop < 1.5 * unseen)
    reach.mu_static = 0.3 * (std::max(0.0, unseen - drop) + unseen / 6);
  if (value(PadNumber::v_min).refusal.empty()) return reach;
  double seen = 0, teeth = 0;
  for (const TrialEvidence& trial : fit.evidence) {
    seen += trial.short_drop;
    teeth += static_cast<double>(trial.short_teeth);
  }
  reach.mu_dynamic = std::max(unseen / 2, teeth > 0 ? seen / teeth : 0);
  if (mu_static.refusal.empty() && mu_static.samples > 10) reach.mu_dynamic = std::max(unseen / 2, drop);
  return reach;
}

/// How many samples a tooth of stick and slip takes at v_min, from mu_dynamic to mu_static along the spring;
/// nothing where that is not known.
std::optional<double> tooth_samples(const ProfileFit& fit, const EvidencePoint& about) {
  const auto value = [&](PadNumber number) -> const PadValue& {
    return fit.values[static_cast<std::size_t>(number)];
  };
  const PadValue &mu_static = value(PadNumber::mu_static), &mu_dynamic = value(PadNumber::mu_dynamic),
                 &v_min = value(PadNumber::v_min);
  if (!mu_static.refusal.empty() || !mu_dynamic.refusal.empty() || !v_min.refusal.empty())
    return std::nullopt;
  double rate_hz = 0, way_m = 0, axes = 0;
  for (const TrialEvidence& trial : fit.evidence) rate_hz = std::max(rate_hz, trial.rate_hz);
  for (const auto& [number, axis] :
       {std::pair(PadNumber::lateral_axis, 0), std::pair(PadNumber::longitudinal_axis, 1)}) {
    if (!value(number).refusal.empty()) continue;
    const SpringBend& bend = about.bend[static_cast<std::size_t>(axis)];
    const auto way = [&](double ratio) { return bend.at(ratio)[0] * ratio; };
    way_m += value(number).value * (1 - way(mu_dynamic.value) / way(mu_static.value));
    ++axes;
  }
  if (axes == 0) return std::nullopt;
  return way_m / axes / v_min.value * rate_hz;
}

/// What the trials say where the delay is as much more as it may be off: positions of a moment later.
std::vector<TrialEvidence> delayed_evidence(const Measurement& measurement,
                                            const std::vector<StickSegments>& segments,
                                            const EvidencePoint& about, double delay_left_s) {
  std::vector<TrialEvidence> delayed;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    MeasuredTrial trial = measurement.trials[i];
    const double by_s = trial.delay_unsure_s + std::abs(delay_left_s);
    const std::vector<double> heights = trial.height_m;
    const auto half = static_cast<std::size_t>(segments[i].half_window);
    for (std::size_t k = 0; k < heights.size(); ++k) {
      trial.position_m[k] += by_s * segments[i].velocity_m_per_s[k];
      std::size_t from = k, to = k;
      while (k - from < half && from > 0 && !trial.starts_anew[from]) --from;
      while (to - k < half && to + 1 < heights.size() && !trial.starts_anew[to + 1]) ++to;
      if (to > from)
        trial.height_m[k] +=
            by_s * trial.rate_hz * (heights[to] - heights[from]) / static_cast<double>(to - from);
    }
    delayed.push_back(trial_evidence(trial, segments[i], about));
  }
  return delayed;
}

/// How far each number moves where the noise of the sensors is a tenth more than was taken off, and ruptures
/// lie a twentieth of a sample later than in its middle (of a bent spring by its share more); ends of slip
/// that pass for stick bend a spring by a thousandth and lengthen it by half of that; slow slip that is left
/// in mu_dynamic is half a thousandth of it, and twice as much where stick hides in it.
/// @param delayed  delayed_evidence
std::array<double, pad_number_keys.size()> moved_by_sampling(const ProfileFit& fit,
                                                             const std::vector<TrialEvidence>& delayed,
                                                             const FitPoint& point, bool has_slow_slip) {
  constexpr double unsure = 0.1, later = 0.05, beside = 0.025, long_tooth = 6;
  // The end of slip may be seen a tooth late where teeth have few samples.
  const double earlier =
      0.5 + std::max(0.0, long_tooth - tooth_samples(fit, point.evidence).value_or(long_tooth));
  const double bent = (point.evidence.bend[0].cubic_share + point.evidence.bend[1].cubic_share) / 2;
  std::vector<TrialEvidence> noisier = fit.evidence;
  for (TrialEvidence& trial : noisier) {
    for (std::size_t axis = 0; axis < 2; ++axis) trial.spring[axis] -= unsure * trial.spring_noise[axis];
    trial.rupture_ratio += later * (1 + bent) * trial.rupture_rise;
    trial.stop_speed_m_per_s += earlier * trial.stop_slowing_m_per_s;
  }
  std::array<double, pad_number_keys.size()> moved{};
  for (const auto* evidence : {&std::as_const(noisier), &delayed}) {
    const PadValues values = pad_numbers(*evidence, std::vector<int>(evidence->size(), 1), point);
    for (std::size_t k = 0; k < moved.size(); ++k) {
      if (fit.values[k].refusal.empty() && values[k].refusal.empty())
        moved[k] += std::abs(values[k].value - fit.values[k].value);
    }
  }
  // Where stick passes for slip before slip is seen to end, it does so within mu_dynamic too.
  if (!fit.values[static_cast<std::size_t>(PadNumber::v_min)].refusal.empty()) {
    double rise = 0;
    long stops = 0;
    for (const TrialEvidence& trial : fit.evidence) rise += trial.stop_rise, stops += trial.stops;
    if (stops > 0)
      moved[static_cast<std::size_t>(PadNumber::mu_dynamic)] +=
          std::max(0.0, rise / static_cast<double>(stops));
  }
  if (point.v_min_by_step) {
    const auto k = static_cast<std::size_t>(PadNumber::v_min);
    moved[k] = SlipBySpeed::bin_width * fit.values[k].value;
  }
  const HiddenReach hidden = hidden_reach(fit, point);
  moved[static_cast<std::size_t>(PadNumber::mu_static)] += hidden.mu_static;
  moved[static_cast<std::size_t>(PadNumber::mu_dynamic)] += hidden.mu_dynamic;
  constexpr double bends = 1e-3;
  for (const PadNumber share : {PadNumber::lateral_cubic_share, PadNumber::longitudinal_cubic_share})
    moved[static_cast<std::size_t>(share)] += bends;
  constexpr double stretches = 5e-4;
  for (const PadNumber length : {PadNumber::lateral_axis, PadNumber::longitudinal_axis,
                                 PadNumber::stick_stiffness, PadNumber::longitudinal_stiffness}) {
    const auto k = static_cast<std::size_t>(length);
    moved[k] += stretches * std::abs(fit.values[k].value);
  }
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

void add_intervals(const std::vector<int>& subject_of, const std::vector<TrialEvidence>& delayed,
                   const FitSettings& settings, FitPoint point, ProfileFit& fit) {
  const bool has_slow_slip = point.slow_slip.has_value();
  point.slow_slip.reset();  // whether it is told is settled for all draws
  std::array<DrawSpread, pad_number_keys.size()> spreads;
  RandomStream random(settings.seed);
  for (int draw = 0; draw < bootstrap_draws; ++draw) {
    const PadValues values =
        pad_numbers(fit.evidence, drawn_times(subject_of, settings.blocks, random), point);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (values[k].refusal.empty()) spreads[k].add(values[k].value);
  }
  std::array<LeftOutSpread, pad_number_keys.size()> without;
  const std::size_t left_out = each_left_out(subject_of, settings.blocks, [&](const LeftOut& one) {
    const PadValues values = pad_numbers(fit.evidence, one.times, point);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (values[k].refusal.empty()) without[k].add(one, values[k].value);
  });
  const auto subjects = static_cast<double>(fit.subjects);
  const auto unsure = moved_by_sampling(fit, delayed, point, has_slow_slip);
  for (std::size_t k = 0; k < spreads.size(); ++k) {
    constexpr double most_missing = 0.05;
    if (!fit.values[k].refusal.empty() || spreads[k].count < (1 - most_missing) * bootstrap_draws) continue;
    const double drawn = settings.blocks == Blocks::subjects
                             ? interval_reach(spreads[k], without[k].deviation(left_out), subjects, 1)
                             : interval_reach(spreads[k], without[k].deviation(left_out),
                                              static_cast<double>(fit.values[k].trials), subjects);
    const double reach = drawn + unsure[k];
    // Draws that all step in the same bin of speed are as sure as that bin is wide.
    const bool is_step = point.v_min_by_step && k == static_cast<std::size_t>(PadNumber::v_min);
    if (drawn > 0 || is_step) fit.interval[k] = {fit.values[k].value - reach, fit.values[k].value + reach};
  }
}

/// Refuses what rests on stick.
void refuse_springs(const std::string& words, PadValues& values) {
  for (const PadNumber number : spring_numbers) {
    PadValue& value = values[static_cast<std::size_t>(number)];
    if (value.refusal.empty()) value.refusal = words;
  }
}

/// An axis that its interval does not tell to half of it is refused, with what rests on the same.
void refuse_vague_springs(bool keeps_told_by_few, ProfileFit& fit) {
  constexpr double vaguest = 0.5, hardly = 0.05;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // A number of the other axis stands beside each.
    const auto k = static_cast<std::size_t>(spring_numbers[axis]);
    const double value = fit.values[k].value;
    if (!fit.values[k].refusal.empty() || !fit.interval[k]) continue;
    const double reach = fit.interval[k]->second - value;
    const long slip = fit.values[static_cast<std::size_t>(PadNumber::mu_dynamic)].samples;
    if (!(reach > vaguest * value)) continue;
    const bool hardly_sticks =
        static_cast<double>(fit.values[k].samples) <= hardly * static_cast<double>(slip);
    if (keeps_told_by_few && !hardly_sticks) continue;
    fit.has_vague_axis[axis] = true;
    const std::string words =
        fmt::format("{} along this axis tells it to -+ {:.0f} % only",
                    hardly_sticks ? "the finger hardly sticks: what is seen of its stick"
                                  : "the trials are too few or too unlike: their stick",
                    100 * reach / value);
    for (std::size_t n = axis; n < spring_numbers.size(); n += 2) {
      const auto other = static_cast<std::size_t>(spring_numbers[n]);
      if (fit.values[other].refusal.empty()) fit.values[other].refusal = words;
      fit.interval[other].reset();
    }
  }
}

/// The finger-pad law takes a cubic_share of 0 to 1. One that noise puts outside is left if its interval
/// reaches into that. One that is a little below 0 is a straight spring's, some of whose ends pass for stick:
/// its interval reaches to 0.
void refuse_odd_cubic_shares(ProfileFit& fit) {
  for (const PadNumber number : {PadNumber::lateral_cubic_share, PadNumber::longitudinal_cubic_share}) {
    const auto k = static_cast<std::size_t>(number);
    PadValue& share = fit.values[k];
    constexpr double as_straight = 0.02;
    if (share.refusal.empty() && share.value < 0 && share.value > -as_straight && fit.interval[k])
      fit.interval[k]->second = std::max(fit.interval[k]->second, 0.0);
    const auto [least, most] = fit.interval[k].value_or(std::pair(share.value, share.value));
    if (!share.refusal.empty() || (most >= -as_straight && least <= 1)) continue;
    share.refusal = fmt::format("the measurement gives a {} of {}; the finger-pad law's spring takes 0 to 1",
                                pad_number_keys[k], rounded_text(share.value, 4));
    fit.interval[k].reset();
  }
}

/// Says of coefficients that are refused that noise may be why.
void tell_noise(const std::vector<StickSegments>& segments, ProfileFit& fit) {
  const auto noisy = std::count_if(segments.begin(), segments.end(),
                                   [](const StickSegments& trial) { return trial.is_too_noisy; });
  if (noisy == 0) return;
  for (const PadNumber number : {PadNumber::mu_static, PadNumber::mu_dynamic}) {
    std::string& refusal = fit.values[static_cast<std::size_t>(number)].refusal;
    if (!refusal.empty())
      refusal += fmt::format(
          "; in {} of {} trials the forces' noise is so large for their load that ruptures cannot be seen in "
          "it",
          noisy, segments.size());
  }
}

}  // namespace

ProfileFit fit_profile(const Measurement& measurement, const FitSettings& settings) {
  ProfileFit fit;
  std::vector<int> subject_of;
  std::vector<StickSegments> segments;
  for (const MeasuredTrial& trial : measurement.trials) {
    subject_of.push_back(trial.subject);
    segments.push_back(stick_segments(trial));
  }
  FitPoint point;
  point.evidence.knows_delay = measurement.knows_delay;
  // The normal law's exponent comes last, where it is far from the half that it is looked for from.
  constexpr int passes = 4, most_passes = 10;
  constexpr double settled_exponent = 1e-3;
  double moved = 0;
  for (int pass = 0; pass < passes || (pass < most_passes && moved > settled_exponent); ++pass) {
    if (pass > 0) {
      const double before = point.evidence.press_exponent;
      point = next_point(fit.evidence, point);
      moved = std::abs(point.evidence.press_exponent - before);
    }
    fit.evidence.clear();
    for (std::size_t i = 0; i < segments.size(); ++i)
      fit.evidence.push_back(trial_evidence(measurement.trials[i], segments[i], point.evidence));
  }
  fit.mu_load_n = point.evidence.load.load_n;
  fit.outliers = outlier_trials(measurement, fit.evidence);
  fit.offset = sensor_offset(measurement, segments);
  const std::vector<int> once(fit.evidence.size(), 1);
  const SpringFit lateral = fit_spring(fit.evidence, once, 0),
                  longitudinal = fit_spring(fit.evidence, once, 1);
  fit.knows_delay = measurement.knows_delay;
  if (!fit.knows_delay && lateral.samples + longitudinal.samples > 0)
    fit.delay_left_s = (static_cast<double>(lateral.samples) * lateral.shape.delay_s +
                        static_cast<double>(longitudinal.samples) * longitudinal.shape.delay_s) /
                       static_cast<double>(lateral.samples + longitudinal.samples);
  ResidualSums residual({point.evidence, {lateral.shape, longitudinal.shape}, point.v_min_by_step});
  for (std::size_t i = 0; i < segments.size(); ++i)
    residual.add(measurement.trials[i], segments[i], fit.evidence[i]);
  fit.subjects = std::set<int>(subject_of.begin(), subject_of.end()).size();
  fit.trials = fit.evidence.size();
  fit.steps = measurement.steps;
  fit.values = pad_numbers(fit.evidence, once, point);
  const std::string hidden =
      point.v_min_by_step ? "" : hidden_stick_words(fit.evidence, once, point.slow_slip, fit.values);
  fit.residual = residual.verdict(
      {point.v_min_by_step || !hidden.empty(), point.v_min_by_step, unseen_drop_share(fit.evidence)});
  tell_noise(segments, fit);
  if (fit.evidence.empty()) {
    for (PadValue& value : fit.values)
      value.refusal =
          measurement.without_force.empty() ? "no trial has contact" : measurement.without_force.front();
    return fit;
  }
  if (!hidden.empty()) refuse_springs(hidden, fit.values);
  add_intervals(subject_of, delayed_evidence(measurement, segments, point.evidence, fit.delay_left_s),
                settings, point, fit);
  refuse_vague_springs(settings.keeps_vague_axes, fit);
  refuse_odd_cubic_shares(fit);
  return fit;
}

}  // namespace fingerpad
