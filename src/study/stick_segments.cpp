#include "study/stick_segments.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "study/local_stiffness.hpp"
#include "study/rupture_search.hpp"
#include "study/sample_noise.hpp"
#include "study/slope_window.hpp"

namespace fingerpad {
namespace {

/// Of a component of noise that is alike on both.
double noise_of_both(const std::vector<Vec2>& samples) {
  double variance = 0;
  std::vector<double> component(samples.size());
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    for (std::size_t i = 0; i < samples.size(); ++i) component[i] = samples[i][axis];
    const double noise = sample_noise(component);
    variance += noise * noise / 2;
  }
  return std::sqrt(variance);
}

/// Of the ratio's component across the motion: ruptures, which many trials are full of, lie along it.
std::vector<double> ratio_across(const std::vector<Vec2>& ratio, const std::vector<Vec2>& velocity) {
  std::vector<double> across;
  for (std::size_t i = 0; i < ratio.size(); ++i) {
    const double speed = velocity[i].norm();
    if (speed > 0)
      across.push_back((ratio[i].x() * velocity[i].y() - ratio[i].y() * velocity[i].x()) / speed);
  }
  return across;
}

/// Of its component across the line that the finger moves along most: a slow finger's direction at a moment
/// is unsure, and as that strays over a window, some of its friction would pass for noise that is joined.
std::vector<double> ratio_across_line(const std::vector<Vec2>& ratio, const std::vector<Vec2>& velocity) {
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vec2& v : velocity) spread += v * v.transpose();
  const Vec2 across = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(0);
  std::vector<double> components;
  components.reserve(ratio.size());
  for (const Vec2& q : ratio) components.push_back(across.dot(q));
  return components;
}

/// Slope of the positions; ruptures do not part them.
Vec2 local_velocity(const MeasuredTrial& trial, const SampleWindow& w) {
  const double middle = static_cast<double>(w.from + w.to - 1) / 2;
  Vec2 drift(0, 0);
  double squares = 0;
  for (std::size_t j = w.from; j < w.to; ++j) {
    const double t = static_cast<double>(j) - middle;
    drift += t * (trial.position_m[j] - trial.position_m[w.from]);
    squares += t * t;
  }
  return squares > 0 ? Vec2(drift / squares * trial.rate_hz) : Vec2(0, 0);
}

/// Samples pressed so lightly that they tell nothing: against what the trial is pressed with, or because the
/// noise of their ratio hides a rupture. Stick whose ruptures are not seen would pass for slip.
std::vector<bool> light_samples(const MeasuredTrial& trial, StickSegments& found) {
  const double most = most_friction(trial, found.usual_normal_n),
               noisy_n = most > 0 ? found.ratio_noise * found.usual_normal_n / (most_noise_share * most) : 0,
               limit_n = std::max(trial.light_share * quantile(trial.normal_force_n, 0.9), noisy_n);
  // What is left of a trial that is mostly too noisy is a choice by noise.
  found.is_too_noisy = noisy_n > found.usual_normal_n;
  if (found.is_too_noisy) return std::vector<bool>(trial.normal_force_n.size(), true);
  std::vector<bool> is_light(trial.normal_force_n.size());
  const SampleWindows windows(trial.starts_anew);
  for (std::size_t i = 0; i < is_light.size(); ++i) {
    // A mean, so that noise does not part samples that are pressed alike.
    const SampleWindow w = windows.around(i, found.half_window);
    double sum_n = 0;
    for (std::size_t j = w.from; j < w.to; ++j) sum_n += trial.normal_force_n[j];
    is_light[i] = sum_n < limit_n * static_cast<double>(w.to - w.from);
  }
  return is_light;
}

/// What windows say under the load that the trial is pressed with. In a ramp a spring may be some times as
/// stiff, for each newton: that would pass for stick beside what is not as stiff, and this for slip.
std::vector<LocalStiffness> at_usual_load(const MeasuredTrial& trial, std::vector<LocalStiffness> locals) {
  constexpr double least = 0.6;  // of what the trial is pressed with; it sways by a fifth as like as not
  const double least_n = least * quantile(trial.normal_force_n, 0.9);
  for (std::size_t i = 0; i < locals.size(); ++i)
    locals[i].is_known = locals[i].is_known && trial.normal_force_n[i] > least_n;
  return locals;
}

/// A drop out of slip is a vibration or noise: ruptures come out of stick, and where it is pulled most.
void drop_false_ruptures(const MeasuredTrial& trial, const std::vector<LocalStiffness>& locals,
                         StickSegments& found) {
  const auto slips = [&](std::size_t j) {
    return locals[j].is_known && locals[j].per_m <= found.border_per_m;
  };
  for (std::size_t i = 1; i < locals.size(); ++i) {
    if (!found.is_rupture[i]) continue;
    std::size_t from = i - 1;
    while (from > 0 && !found.begins_run[from] && !slips(from - 1)) --from;
    if (!slips(i - 1) && !drops_below_its_tooth(trial, found, from, i)) continue;
    found.is_rupture[i] = false;
    found.begins_run[i] = trial.starts_anew[i];
  }
}

/// The phases by the local stiffness alone.
void tell_phases(const MeasuredTrial& trial, const std::vector<LocalStiffness>& locals,
                 StickSegments& found) {
  found.phase.assign(locals.size(), PadPhase::unknown);
  for (std::size_t i = 0; i < locals.size(); ++i) {
    if (!locals[i].is_known) continue;
    const bool against = trial.force_ratio[i].dot(found.velocity_m_per_s[i]) < 0;
    if (locals[i].per_m > found.border_per_m) found.phase[i] = PadPhase::stick;
    if (locals[i].per_m <= found.border_per_m && against) found.phase[i] = PadPhase::slip;
  }
}

/// Slip with little friction is none: where it follows the displacement somewhat, it is stick.
void take_soft_stick(const MeasuredTrial& trial, const std::vector<LocalStiffness>& locals,
                     StickSegments& found) {
  constexpr double least_friction = 0.5, least_stiffness = 0.3;  // of slip's median, and of the border
  std::vector<double> frictions;
  for (std::size_t i = 0; i < locals.size(); ++i)
    if (found.phase[i] == PadPhase::slip) frictions.push_back(trial.force_ratio[i].norm());
  const double least = least_friction * median_of(frictions);
  for (std::size_t i = 0; i < locals.size(); ++i) {
    if (found.phase[i] != PadPhase::slip || trial.force_ratio[i].norm() > least) continue;
    found.phase[i] =
        locals[i].per_m > least_stiffness * found.border_per_m ? PadPhase::stick : PadPhase::unknown;
  }
}

}  // namespace

StickSegments stick_segments(const MeasuredTrial& trial) {
  return stick_segments(trial, 0);
}

StickSegments stick_segments(const MeasuredTrial& trial, double axes_exponent) {
  StickSegments found;
  found.axes_exponent = axes_exponent;
  found.half_window = slope_half_window(trial.rate_hz);
  found.position_noise_m = noise_of_both(trial.position_m);
  const std::size_t samples = trial.position_m.size();
  found.velocity_m_per_s.reserve(samples);
  const SampleWindows windows(trial.starts_anew);
  for (std::size_t i = 0; i < samples; ++i)
    found.velocity_m_per_s.push_back(local_velocity(trial, windows.around(i, found.half_window)));
  const std::vector<double> across = ratio_across(trial.force_ratio, found.velocity_m_per_s);
  found.ratio_noise = std::min(noise_of_both(trial.force_ratio), sample_noise(across));
  found.joined_noise = std::min(joined_noise(across),
                                joined_noise(ratio_across_line(trial.force_ratio, found.velocity_m_per_s)));
  find_ruptures(trial, found);
  const std::vector<bool> is_light = light_samples(trial, found);
  double squares = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    if (!is_light[i]) squares += trial.force_ratio[i].squaredNorm();
    if (!is_light[i]) continue;
    ++found.light_samples;
    found.is_rupture[i] = false;
    found.begins_run[i] = true;
    if (i + 1 < samples) found.begins_run[i + 1] = true;
  }
  const WindowSums sums(trial, found);
  std::vector<LocalStiffness> locals = local_stiffnesses(trial, found, sums, is_light);
  found.border_per_m =
      border_per_m(at_usual_load(trial, locals), std::sqrt(squares / static_cast<double>(samples)));
  drop_false_ruptures(trial, locals, found);
  locals = local_stiffnesses(trial, found, sums, is_light);
  tell_phases(trial, locals, found);
  take_soft_stick(trial, locals, found);
  return found;
}

std::vector<double> local_stiffness_per_m(const MeasuredTrial& trial, const StickSegments& segments) {
  StickSegments found = segments;
  const std::vector<bool> is_light = light_samples(trial, found);
  std::vector<double> per_m;
  for (const LocalStiffness& local : local_stiffnesses(trial, found, WindowSums(trial, found), is_light))
    per_m.push_back(local.is_known ? local.per_m : std::numeric_limits<double>::quiet_NaN());
  return per_m;
}

}  // namespace fingerpad
