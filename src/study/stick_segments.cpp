#include "study/stick_segments.hpp"

#include <algorithm>
#include <cmath>

#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

double median_of(const std::vector<double>& values) {
  return values.empty() ? 0 : quantile(values, 0.5);
}

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

/// The window around a sample, [from, to), within its run.
struct SampleWindow {
  std::size_t from, to;
};

SampleWindow window_around(std::size_t i, const std::vector<bool>& begins_run, int half_window) {
  const auto half = static_cast<std::size_t>(half_window);
  SampleWindow window{i, i + 1};
  while (window.from > 0 && i - window.from < half && !begins_run[window.from]) --window.from;
  while (window.to < begins_run.size() && window.to - i <= half && !begins_run[window.to]) ++window.to;
  return window;
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

/// How much the ratio's length falls in the step to sample i.
double drop_at(const MeasuredTrial& trial, std::size_t i) {
  return trial.force_ratio[i - 1].norm() - trial.force_ratio[i].norm();
}

bool ruptures_at(std::size_t i, const MeasuredTrial& trial, int half_window, double noise) {
  constexpr double deviations = 4.5, shares = 1, least_share = 0.08;
  const double least = std::max(deviations * std::sqrt(2.0) * noise,
                                least_share * trial.force_ratio[i - 1].norm()),
               drop = drop_at(trial, i);
  if (!(drop > 0.5 * least)) return false;
  const auto half = static_cast<std::size_t>(half_window);
  std::vector<double> drops, sizes;
  for (std::size_t j = i > half ? i - half : 1; j <= std::min(i + half, trial.force_ratio.size() - 1); ++j) {
    if (j == i || trial.starts_anew[j]) continue;
    drops.push_back(drop_at(trial, j));
    sizes.push_back(std::abs(drops.back()));
  }
  return drop - median_of(drops) > least + shares * median_of(sizes);
}

void find_ruptures(const MeasuredTrial& trial, StickSegments& found) {
  found.begins_run = trial.starts_anew;
  found.is_rupture.assign(trial.force_ratio.size(), false);
  // The sensor's noise is one of forces: the lighter the press, the more of it is in the ratio.
  const double usual_n = quantile(trial.normal_force_n, 0.5);
  for (std::size_t i = 1; i < trial.force_ratio.size(); ++i) {
    const double noise = found.ratio_noise * std::max(1.0, usual_n / trial.normal_force_n[i]);
    if (trial.starts_anew[i] || !ruptures_at(i, trial, found.half_window, noise)) continue;
    found.is_rupture[i] = found.begins_run[i] = true;
  }
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

  LocalStiffness stiffness(const SampleWindow& w, double noise_m) const {
    const auto count = static_cast<double>(w.to - w.from);
    const Sums &from = sums_[w.from], &to = sums_[w.to];
    const Vec2 x = to.x - from.x;
    const double spread = to.xx - from.xx - x.squaredNorm() / count;
    const double pull = x.dot(to.q - from.q) / count - (to.xq - from.xq);
    LocalStiffness local;
    local.is_known = w.to - w.from >= 4 && spread > 16 * 2 * noise_m * noise_m * count;
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
    if (counts[0] > 0) low = sums[0] / counts[0];
    if (counts[1] > 0) high = sums[1] / counts[1];
  }
  // A spring that would take five centimetres to reach these forces is no finger's.
  constexpr double softest_reach_m = 0.05;
  if (high * softest_reach_m < ratio_rms) return 2 * std::abs(high) + ratio_rms / softest_reach_m;
  return low > 0.4 * high ? 0.25 * low : high / 2;
}

/// Samples pressed so lightly, against what the trial is pressed with, that their ratio is mostly noise.
std::vector<bool> light_samples(const MeasuredTrial& trial) {
  constexpr double light = 0.25;
  const double limit_n = light * quantile(trial.normal_force_n, 0.9);
  std::vector<bool> is_light(trial.normal_force_n.size());
  for (std::size_t i = 0; i < is_light.size(); ++i) is_light[i] = trial.normal_force_n[i] < limit_n;
  return is_light;
}

/// The local stiffness at each sample, over windows that are widened where the pad hardly moves.
std::vector<LocalStiffness> local_stiffnesses(const StickSegments& found, const WindowSums& sums,
                                              const std::vector<bool>& is_light) {
  constexpr int widest = 16;  // times the half window
  std::vector<LocalStiffness> locals(is_light.size());
  for (std::size_t i = 0; i < locals.size(); ++i) {
    if (is_light[i]) continue;
    for (int widened = 1; widened <= widest && !locals[i].is_known; widened *= 2)
      locals[i] = sums.stiffness(window_around(i, found.begins_run, widened * found.half_window),
                                 found.position_noise_m);
  }
  return locals;
}

/// A drop out of slip is a vibration or noise: ruptures come out of stick.
void drop_false_ruptures(const MeasuredTrial& trial, const std::vector<LocalStiffness>& locals,
                         StickSegments& found) {
  for (std::size_t i = 1; i < locals.size(); ++i) {
    if (!found.is_rupture[i] || !locals[i - 1].is_known || locals[i - 1].per_m > found.border_per_m) continue;
    found.is_rupture[i] = false;
    found.begins_run[i] = trial.starts_anew[i];
  }
}

}  // namespace

StickSegments stick_segments(const MeasuredTrial& trial) {
  constexpr double half_window_s = 6e-3;
  StickSegments found;
  found.half_window = std::max(3, static_cast<int>(std::lround(half_window_s * trial.rate_hz)));
  found.position_noise_m = noise_of_both(trial.position_m);
  found.ratio_noise = noise_of_both(trial.force_ratio);
  find_ruptures(trial, found);
  const std::size_t samples = trial.position_m.size();
  const std::vector<bool> is_light = light_samples(trial);
  double squares = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    found.velocity_m_per_s.push_back(
        local_velocity(trial, window_around(i, trial.starts_anew, found.half_window)));
    if (!is_light[i]) squares += trial.force_ratio[i].squaredNorm();
    if (!is_light[i]) continue;
    found.is_rupture[i] = false;
    found.begins_run[i] = true;
    if (i + 1 < samples) found.begins_run[i + 1] = true;
  }
  const WindowSums sums(trial);
  std::vector<LocalStiffness> locals = local_stiffnesses(found, sums, is_light);
  found.border_per_m = border_per_m(locals, std::sqrt(squares / static_cast<double>(samples)));
  drop_false_ruptures(trial, locals, found);
  locals = local_stiffnesses(found, sums, is_light);
  found.phase.assign(samples, PadPhase::unknown);
  for (std::size_t i = 0; i < samples; ++i) {
    if (!locals[i].is_known) continue;
    const bool against = trial.force_ratio[i].dot(found.velocity_m_per_s[i]) < 0;
    if (locals[i].per_m > found.border_per_m) found.phase[i] = PadPhase::stick;
    if (locals[i].per_m <= found.border_per_m && against) found.phase[i] = PadPhase::slip;
  }
  return found;
}

std::string_view reason_text(BoundaryReason reason) noexcept {
  switch (reason) {
    case BoundaryReason::touchdown:
      return "contact";
    case BoundaryReason::rupture:
      return "ratio drops";
    case BoundaryReason::spring_gives:
      return "spring gives";
    case BoundaryReason::spring_holds:
      return "spring holds";
    case BoundaryReason::hardly_moves:
      return "hardly moves";
    case BoundaryReason::moves_again:
      return "moves again";
  }
  return "";
}

std::vector<PhaseBoundary> phase_boundaries(const MeasuredTrial& trial, const StickSegments& segments) {
  const auto reason = [&](std::size_t i, PadPhase before, PadPhase after) {
    if (trial.starts_anew[i]) return BoundaryReason::touchdown;
    if (segments.is_rupture[i]) return BoundaryReason::rupture;
    if (after == PadPhase::unknown) return BoundaryReason::hardly_moves;
    if (before == PadPhase::unknown) return BoundaryReason::moves_again;
    return after == PadPhase::slip ? BoundaryReason::spring_gives : BoundaryReason::spring_holds;
  };
  std::vector<PhaseBoundary> found;
  for (std::size_t i = 0; i < segments.phase.size(); ++i) {
    const PadPhase before = i > 0 ? segments.phase[i - 1] : PadPhase::unknown, after = segments.phase[i];
    if (before == after && !segments.is_rupture[i] && !trial.starts_anew[i]) continue;
    found.push_back({i, before, after, reason(i, before, after)});
  }
  return found;
}

}  // namespace fingerpad
