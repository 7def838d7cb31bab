#include "study/stick_segments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The window around a sample, [from, to), within its run.
struct SampleWindow {
  std::size_t from, to;
};

/// The windows around all samples, which end where their run does.
class SampleWindows {
 public:
  /// @param begins_run  of each sample
  explicit SampleWindows(const std::vector<bool>& begins_run) : run_(begins_run.size()) {
    for (std::size_t from = 0, to = 0; from < run_.size(); from = to) {
      to = from + 1;
      while (to < run_.size() && !begins_run[to]) ++to;
      std::fill(run_.begin() + static_cast<std::ptrdiff_t>(from),
                run_.begin() + static_cast<std::ptrdiff_t>(to), SampleWindow{from, to});
    }
  }

  SampleWindow around(std::size_t i, int half_window) const {
    const auto half = static_cast<std::size_t>(half_window);
    return {std::max(run_[i].from, i - std::min(i, half)), std::min(run_[i].to, i + half + 1)};
  }

 private:
  std::vector<SampleWindow> run_;  ///< that each sample is in
};

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

/// What a window says.
struct LocalStiffness {
  double per_m = 0;
  bool is_known = false;
};

/// Sums up to each sample, so that a window of any width is told by its two ends.
class WindowSums {
 public:
  explicit WindowSums(const MeasuredTrial& trial) : sums_(trial.position_m.size() + 1) {
    const Vec2 origin = trial.position_m.front();
    for (std::size_t i = 0; i < trial.position_m.size(); ++i) {
      const Vec2 x = trial.position_m[i] - origin, q = trial.force_ratio[i];
      sums_[i + 1] = sums_[i];
      sums_[i + 1].x += x;
      sums_[i + 1].q += q;
      sums_[i + 1].xx += x.squaredNorm();
      sums_[i + 1].xq += x.dot(q);
    }
  }

  /// @param least_m2  spread below which the window tells nothing
  LocalStiffness stiffness(const SampleWindow& w, double noise_m, double least_m2) const {
    const auto count = static_cast<double>(w.to - w.from);
    const Sums &from = sums_[w.from], &to = sums_[w.to];
    const Vec2 x = to.x - from.x;
    const double spread = to.xx - from.xx - x.squaredNorm() / count;
    const double pull = x.dot(to.q - from.q) / count - (to.xq - from.xq);
    LocalStiffness local;
    local.is_known = w.to - w.from >= 4 &&
                     spread > std::max(2 * std::pow(least_window_spread * noise_m, 2) * count, least_m2);
    if (local.is_known) local.per_m = pull / spread;
    return local;
  }

 private:
  struct Sums {
    Vec2 x{0, 0}, q{0, 0};
    double xx = 0, xq = 0;
  };
  std::vector<Sums> sums_;
};

/// Half the mean of the stiffer of two groups; where there is no second group, what puts all on one side.
double border_per_m(const std::vector<LocalStiffness>& locals, double ratio_rms) {
  std::vector<double> known;
  for (const LocalStiffness& local : locals)
    if (local.is_known) known.push_back(local.per_m);
  if (known.empty()) return 0;
  std::sort(known.begin(), known.end());
  double low = known[known.size() / 20], high = known[known.size() - 1 - known.size() / 20];
  for (int pass = 0; pass < 30; ++pass) {
    double sums[2] = {0, 0}, counts[2] = {0, 0};
    for (const double k : known) {
      const int group = k > (low + high) / 2 ? 1 : 0;
      sums[group] += k;
      counts[group] += 1;
    }
    const double before[2] = {low, high};
    if (counts[0] > 0) low = sums[0] / counts[0];
    if (counts[1] > 0) high = sums[1] / counts[1];
    if (low == before[0] && high == before[1]) break;
  }
  // A spring that would take five centimetres to reach these forces is no finger's.
  constexpr double softest_reach_m = 0.05;
  if (high * softest_reach_m < ratio_rms) return 2 * std::abs(high) + ratio_rms / softest_reach_m;
  return low > 0.4 * high ? 0.25 * low : high / 2;
}

/// Samples pressed so lightly that they tell nothing: against what the trial is pressed with, or because the
/// noise of their ratio hides a rupture. Stick whose ruptures are not seen would pass for slip.
std::vector<bool> light_samples(const MeasuredTrial& trial, StickSegments& found) {
  constexpr double light = 0.25;  // of what the trial is pressed with
  const double most = most_friction(trial, found.usual_normal_n),
               noisy_n = most > 0 ? found.ratio_noise * found.usual_normal_n / (most_noise_share * most) : 0,
               limit_n = std::max(light * quantile(trial.normal_force_n, 0.9), noisy_n);
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

/// The local stiffness at each sample, over windows that are widened where the pad hardly moves, until they
/// tell it by four deviations of the noise from the border (`border_per_m`, where it is known).
std::vector<LocalStiffness> local_stiffnesses(const MeasuredTrial& trial, const StickSegments& found,
                                              const WindowSums& sums, const std::vector<bool>& is_light) {
  constexpr int widest = 16;  // times the half window
  constexpr double deviations = 4;
  std::vector<LocalStiffness> locals(is_light.size());
  const SampleWindows windows(found.begins_run);
  for (std::size_t i = 0; i < locals.size(); ++i) {
    if (is_light[i]) continue;
    const double least_m =
        found.border_per_m > 0 ? deviations * ratio_noise_at(trial, found, i) / found.border_per_m : 0;
    for (int widened = 1; widened <= widest && !locals[i].is_known; widened *= 2)
      locals[i] = sums.stiffness(windows.around(i, widened * found.half_window), found.position_noise_m,
                                 least_m * least_m);
  }
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
  StickSegments found;
  found.half_window = slope_half_window(trial.rate_hz);
  found.position_noise_m = noise_of_both(trial.position_m);
  const std::size_t samples = trial.position_m.size();
  found.velocity_m_per_s.reserve(samples);
  const SampleWindows windows(trial.starts_anew);
  for (std::size_t i = 0; i < samples; ++i)
    found.velocity_m_per_s.push_back(local_velocity(trial, windows.around(i, found.half_window)));
  const std::vector<double> across = ratio_across(trial.force_ratio, found.velocity_m_per_s);
  found.ratio_noise = std::min(noise_of_both(trial.force_ratio), sample_noise(across));
  found.joined_noise = joined_noise(across);
  find_ruptures(trial, found);
  const std::vector<bool> is_light = light_samples(trial, found);
  double squares = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    if (!is_light[i]) squares += trial.force_ratio[i].squaredNorm();
    if (!is_light[i]) continue;
    found.is_rupture[i] = false;
    found.begins_run[i] = true;
    if (i + 1 < samples) found.begins_run[i + 1] = true;
  }
  const WindowSums sums(trial);
  std::vector<LocalStiffness> locals = local_stiffnesses(trial, found, sums, is_light);
  found.border_per_m = border_per_m(locals, std::sqrt(squares / static_cast<double>(samples)));
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
  for (const LocalStiffness& local : local_stiffnesses(trial, found, WindowSums(trial), is_light))
    per_m.push_back(local.is_known ? local.per_m : std::numeric_limits<double>::quiet_NaN());
  return per_m;
}

}  // namespace fingerpad
