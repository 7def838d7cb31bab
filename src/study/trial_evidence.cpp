#include "study/trial_evidence.hpp"

#include <cmath>

#include "study/law_residual.hpp"
#include "study/phase_stretch.hpp"
#include "study/rupture_search.hpp"
#include "study/rupture_sums.hpp"
#include "study/sample_noise.hpp"
#include "study/slip_sums.hpp"
#include "study/spring_sums.hpp"
#include "study/spring_way.hpp"

namespace fingerpad {
namespace {

using Vec4 = Eigen::Vector4d;

/// Depth against normal force, over means of some samples. Light ones are left out: their noise is a large
/// part.
void add_press(const MeasuredTrial& trial, double exponent, TrialEvidence& evidence) {
  constexpr double group_s = 10e-3, light = 0.1;
  const auto size = static_cast<std::size_t>(std::max(1L, std::lround(group_s * trial.rate_hz)));
  const double least_n = light * quantile(trial.normal_force_n, 0.9);
  std::vector<Vec4> groups;
  Vec4 mean = Vec4::Zero();
  for (std::size_t from = 0; from + size <= trial.height_m.size(); from += size) {
    Vec4 group = Vec4::Zero();
    bool is_whole = true;
    for (std::size_t i = from; i < from + size; ++i) {
      const double load_n = trial.normal_force_n[i];
      is_whole = is_whole && (i == from || !trial.starts_anew[i]) && load_n > least_n;
      if (!is_whole) break;
      const double term = std::pow(load_n, exponent), log_load = std::log(load_n);
      group += Vec4(-trial.height_m[i], term, term * log_load, log_load) / static_cast<double>(size);
    }
    if (!is_whole) continue;
    groups.push_back(group);
    mean += group;
  }
  evidence.press_log_load += mean[3];
  mean /= static_cast<double>(std::max<std::size_t>(groups.size(), 1));
  for (const Vec4& group : groups) {
    const Vec4 off = group - mean;
    evidence.press += off.head<3>() * off.head<3>().transpose();
    evidence.press_load_2 += off[3] * off[3];
  }
  evidence.press_samples += static_cast<long>(groups.size() * size);
  evidence.press_groups += static_cast<long>(groups.size());
}

/// Whether the finger was pulled much less within the stick before a sample than in slip. A vibration of
/// slip, or stick that gives way again within a few samples, passes for stick here and there, with friction
/// as it is.
bool was_let_go(const StickSegments& segments, const std::vector<Vec2>& ratio, std::size_t end,
                double slip_ratio) {
  constexpr double surely = 0.75;
  const Vec2 forward = segments.velocity_m_per_s[end].normalized();
  for (std::size_t i = end; i-- > 0 && segments.phase[i] != PadPhase::slip;) {
    if (-ratio[i].dot(forward) < surely * slip_ratio) return true;
    if (segments.begins_run[i]) break;
  }
  return false;
}

/// How often stick ends in slip, and drops as it does; and the drop that noise would hide.
void add_gives(const MeasuredTrial& trial, const StickSegments& segments, const std::vector<Vec2>& ratio,
               TrialEvidence& evidence) {
  const std::size_t shortest = 4 * static_cast<std::size_t>(segments.half_window);
  const double slip_ratio =
      evidence.slip_samples > 0 ? evidence.slip_ratio / static_cast<double>(evidence.slip_samples) : 0;
  for (const PhaseStretch& slip : phase_stretches(segments, PadPhase::slip)) {
    if (slip.to - slip.from < shortest || slip.from == 0 || trial.starts_anew[slip.from]) continue;
    const bool was_stick = segments.phase[slip.from - 1] == PadPhase::stick;
    if (!was_stick && !segments.is_rupture[slip.from]) continue;
    const bool is_new = slip_ratio == 0 || was_let_go(segments, ratio, slip.from, slip_ratio);
    evidence.strokes += is_new ? 1 : 0;
    evidence.stroke_drops += is_new && segments.is_rupture[slip.from] ? 1 : 0;
    if (!is_new && !segments.is_rupture[slip.from]) continue;
    ++evidence.gives;
    evidence.drops += segments.is_rupture[slip.from] ? 1 : 0;
  }
  if (slip_ratio > 0) evidence.unseen_drop = least_drop(segments.ratio_noise, slip_ratio);
}

/// Whether teeth at v_min, from slip's friction up to mu_s, are hardly seen in the trial.
bool may_hide_teeth(const EvidencePoint& about, const TrialEvidence& evidence) {
  constexpr double surely_seen = 1.5, fewest_samples = 3.5;
  const double mu_static = about.mu_static_of(evidence);
  if (!(mu_static > 0) || !(about.v_min_m_per_s > 0) || evidence.slip_samples == 0) return false;
  const auto slip_samples = static_cast<double>(evidence.slip_samples);
  const double slip_ratio = evidence.slip_ratio / slip_samples, drop = mu_static - slip_ratio;
  if (drop < surely_seen * evidence.unseen_drop) return true;
  const auto pulled = [&](std::size_t axis) {
    return evidence.spring[axis](spring_straight, spring_straight);
  };
  const Vec2 forward = pulled(0) > pulled(1) ? Vec2::UnitX() : Vec2::UnitY();
  const double longer = about.axes_at(std::exp(evidence.slip_log_load / slip_samples)),
               tooth_m = longer * (spring_way_m(evidence, about.bend, forward, mu_static) -
                                   spring_way_m(evidence, about.bend, forward, slip_ratio));
  return tooth_m > 0 && tooth_m * evidence.rate_hz < fewest_samples * about.v_min_m_per_s;
}

}  // namespace

std::size_t vibration_window(double rate_hz) {
  std::size_t length = 32;
  while (static_cast<double>(length) * 1.5 < 0.25 * rate_hz) length *= 2;
  return length;
}

TrialEvidence trial_evidence(const MeasuredTrial& trial, const StickSegments& segments,
                             const EvidencePoint& about) {
  TrialEvidence evidence;
  evidence.subject = trial.subject;
  evidence.has_direction = trial.has_direction;
  evidence.inclination_deg = trial.inclination_deg;
  evidence.rate_hz = trial.rate_hz;
  evidence.position_noise_m = segments.position_noise_m;
  evidence.lines_left_in = trial.lines_left_in;
  const std::vector<Vec2> ratio = ratio_at_load(trial, about.load);
  add_slip_sums(trial, segments, ratio, about, evidence);
  add_gives(trial, segments, ratio, evidence);
  add_spring_sums(trial, segments, ratio, about, evidence);
  evidence.hides_teeth = may_hide_teeth(about, evidence);
  add_rupture_sums(trial, segments, ratio, about, evidence);
  add_stop_sums(trial, segments, ratio, about, evidence);
  add_press(trial, about.press_exponent, evidence);
  return evidence;
}

TrialEvidence press_evidence(const MeasuredTrial& trial, double exponent) {
  TrialEvidence evidence;
  evidence.subject = trial.subject;
  evidence.inclination_deg = trial.inclination_deg;
  add_press(trial, exponent, evidence);
  return evidence;
}

}  // namespace fingerpad
