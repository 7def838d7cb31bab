#include "study/air_evidence.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

enum class FingerPlace { unknown, air, plate };

/// What the evidence is read from.
struct TrialSenses {
  const RecordedTrial& trial;
  double noise_n, press_n;
  std::vector<double> normal_n;
  Eigen::Index window;                ///< samples that a mean height is of
  std::vector<double> mean_height_m;  ///< of the samples [i, i + window)
  double height_noise_m, height_spread_m;

  TrialSenses(const RecordedTrial& of, double noise, double press)
      : trial(of), noise_n(noise), press_n(press) {
    constexpr double window_s = 0.02;
    window = std::max<Eigen::Index>(1, std::lround(window_s * trial.rate_hz));
    std::vector<double> height_m;
    for (Eigen::Index i = 0; i < trial.samples(); ++i) {
      height_m.push_back(trial.normal_W.dot(trial.seen_W().col(i)));
      normal_n.push_back(trial.normal_W.dot(trial.force_W.col(i)));
    }
    height_noise_m = sample_noise(height_m);
    height_spread_m = quantile(height_m, 0.99) - quantile(height_m, 0.01);
    // From their middle, so that a sum keeps what a mean differs by.
    const double middle_m = quantile(height_m, 0.5);
    double sum_m = 0;
    for (Eigen::Index i = 0; i < trial.samples(); ++i) {
      sum_m += height_m[static_cast<std::size_t>(i)] - middle_m;
      if (i + 1 < window) continue;
      mean_height_m.push_back(sum_m / static_cast<double>(window));
      sum_m -= height_m[static_cast<std::size_t>(i + 1 - window)] - middle_m;
    }
  }

  /// Mean, over all heights; less where the finger is lifted.
  double stiffness_n_per_m() const { return press_n / height_spread_m; }

  /// Whether the heights are a finger's that presses and lifts, and not a rail's.
  bool tell_height() const {
    constexpr double least_m = 2e-5, beyond_noise = 10;
    return height_spread_m > std::max(least_m, beyond_noise * height_noise_m);
  }
};

/// How far the mean heights of samples [from, to) spread, those of them that there are; nothing of too few.
std::optional<double> mean_height_spread_m(const TrialSenses& sensed, Eigen::Index from, Eigen::Index to) {
  from = std::max<Eigen::Index>(from, 0);
  if (to - from < sensed.window) return std::nullopt;
  const auto means = sensed.mean_height_m.begin();
  const auto [lowest, highest] = std::minmax_element(means + from, means + (to - sensed.window + 1));
  return *highest - *lowest;
}

/// Outward from one end of a run, the first sample that is plainly above it; none where the trial ends, or a
/// sample is missing, before that.
std::optional<Eigen::Index> first_above(const TrialSenses& sensed, const StillRun& run, Eigen::Index way) {
  constexpr double plainly = 6, longest_s = 2;
  const auto most = static_cast<Eigen::Index>(longest_s * sensed.trial.rate_hz);
  Eigen::Index i = way < 0 ? run.from - 1 : run.to;
  for (Eigen::Index steps = 0; steps < most && i >= 0 && i < sensed.trial.samples(); ++steps, i += way) {
    const auto k = static_cast<std::size_t>(i);
    if (sensed.trial.origin[k] == SampleOrigin::missing) return std::nullopt;
    if (sensed.normal_n[k] > run.normal_n + plainly * sensed.noise_n) return i;
  }
  return std::nullopt;
}

/// What lies between a run's neighbours that are plainly above it: all of a moment in which the finger is off
/// the plate or presses lightly, of which runs are the still parts.
struct LowPhase {
  Eigen::Index from, to;
  bool begins_pressed, ends_pressed;

  LowPhase(const TrialSenses& sensed, const StillRun& run) {
    const auto before = first_above(sensed, run, -1), after = first_above(sensed, run, 1);
    from = before ? *before + 1 : run.from;
    to = after ? *after : run.to;
    begins_pressed = before.has_value();
    ends_pressed = after.has_value();
  }
  bool operator==(const LowPhase&) const = default;
};

/// Whether the force falls to a low phase within one sample, or rises from it.
bool falls_at_once(const TrialSenses& sensed, const LowPhase& phase) {
  constexpr double most_of_it = 0.5;
  const auto steps = [&](Eigen::Index pressed, Eigen::Index low) {
    return sensed.normal_n[static_cast<std::size_t>(pressed)] -
               sensed.normal_n[static_cast<std::size_t>(low)] >
           most_of_it * sensed.press_n;
  };
  return (phase.begins_pressed && steps(phase.from - 1, phase.from)) ||
         (phase.ends_pressed && steps(phase.to, phase.to - 1));
}

/// Whether the force along the plate changes while the normal force does not: as friction does, and no
/// sensor's offset, which drifts straight. By means over 50 ms, from which hum is gone.
bool rubs_within(const TrialSenses& sensed, const LowPhase& phase) {
  constexpr double window_s = 0.05, surely = 6;
  const RecordedTrial& trial = sensed.trial;
  const auto window = std::max<Eigen::Index>(4, std::lround(window_s * trial.rate_hz));
  const Eigen::Index windows = (phase.to - phase.from) / window;
  if (windows < 3) return false;
  Points means(3, windows);
  for (Eigen::Index w = 0; w < windows; ++w)
    means.col(w) = trial.force_W.middleCols(phase.from + w * window, window).rowwise().mean();
  means -= trial.normal_W * (trial.normal_W.transpose() * means);
  const Eigen::VectorXd along = Eigen::VectorXd::LinSpaced(windows, -1, 1);
  means.colwise() -= means.rowwise().mean().eval();
  means -= (means * along / along.squaredNorm()) * along.transpose();
  return (means.rowwise().maxCoeff() - means.rowwise().minCoeff()).maxCoeff() > surely * sensed.noise_n;
}

/// What a run's heights say, up to where it is pressed before and after. Force may lag them by up to 50 ms,
/// which is not known yet: a finger on the plate keeps its height at one of these lags; one in the air that
/// is pressed at both ends at none.
FingerPlace place_by_height(const TrialSenses& sensed, const LowPhase& phase) {
  constexpr double most_lag_s = 0.05, lags = 10;
  // A pad is softer where it presses little; its noise passes for change.
  constexpr double softer = 3, beyond_noise = 8;
  const Eigen::Index from = phase.from, to = phase.to;
  const auto [least_n, most_n] =
      std::minmax_element(sensed.normal_n.begin() + from, sensed.normal_n.begin() + to);
  const double yields_m =
      softer * (*most_n - *least_n) / sensed.stiffness_n_per_m() +
      beyond_noise * sensed.height_noise_m / std::sqrt(static_cast<double>(sensed.window));
  const std::optional<double> spread_m = mean_height_spread_m(sensed, from, to);
  if (!spread_m) return FingerPlace::unknown;
  double least_m = *spread_m;
  const bool is_flat = least_m < yields_m;
  for (double lag = 1; lag <= lags; ++lag) {
    const auto late = static_cast<Eigen::Index>(std::lround(lag / lags * most_lag_s * sensed.trial.rate_hz));
    if (const auto later_m = mean_height_spread_m(sensed, from - late, to - late))
      least_m = std::min(least_m, *later_m);
  }
  if (!(least_m < yields_m)) return FingerPlace::air;
  const bool is_plate = (phase.begins_pressed && phase.ends_pressed) ||
                        (is_flat && (phase.begins_pressed || phase.ends_pressed));
  return is_plate ? FingerPlace::plate : FingerPlace::unknown;
}

/// A run that moves along the plate: which way, and what force along the plate it has.
struct MovingRun {
  std::size_t run;
  double middle;  ///< sample
  Vec3 way, force_n;
  double samples;
};

std::optional<MovingRun> moved_along(const TrialSenses& sensed, const StillRun& run, std::size_t number) {
  constexpr double least_m_per_s = 2e-3, beyond_noise = 5;
  const Points& places = sensed.trial.seen_W();
  const Vec3 normal = sensed.trial.normal_W;
  const auto along_plate = [&normal](const Vec3& v) -> Vec3 { return v - normal * normal.dot(v); };
  const Vec3 way = along_plate(places.col(run.to - 1) - places.col(run.from));
  const auto count = static_cast<double>(run.to - run.from);
  const double least_m =
      std::max(least_m_per_s * count / sensed.trial.rate_hz, beyond_noise * sensed.height_noise_m);
  if (!(way.norm() > least_m)) return std::nullopt;
  const Vec3 mean_n = sensed.trial.force_W.middleCols(run.from, run.to - run.from).rowwise().mean();
  return MovingRun{number, 0.5 * static_cast<double>(run.from + run.to), way.normalized(),
                   along_plate(mean_n), count};
}

/// Whether all runs go one way.
bool go_one_way(const std::vector<MovingRun>& moving) {
  constexpr double alike = 0.8;  // cosine
  return std::all_of(moving.begin(), moving.end(),
                     [&](const MovingRun& one) { return one.way.dot(moving[0].way) > alike; });
}

/// Whether what opposes the motion, beside an offset that drifts, is more than chance. Of fewer than four
/// runs, or of such as all go one way, the two cannot be told apart.
bool opposes_motion(const TrialSenses& sensed, const std::vector<MovingRun>& moving) {
  constexpr double surely = 5, least_share = 0.01;
  constexpr Eigen::Index unknowns = 7, in_plane = 2, fewest = 4;
  const auto runs = static_cast<Eigen::Index>(moving.size());
  if (runs < fewest || go_one_way(moving)) return false;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3 * runs, unknowns);
  Eigen::VectorXd forces(3 * runs);
  double samples = 0;
  for (Eigen::Index r = 0; r < runs; ++r) {
    const MovingRun& one = moving[static_cast<std::size_t>(r)];
    rows.block<3, 1>(3 * r, 0) = -one.way;
    rows.block<3, 3>(3 * r, 1).setIdentity();
    rows.block<3, 3>(3 * r, 4) =
        Eigen::Matrix3d::Identity() * (one.middle / static_cast<double>(sensed.trial.samples()) - 0.5);
    forces.segment<3>(3 * r) = one.force_n;
    samples += one.samples / static_cast<double>(runs);
  }
  const Eigen::MatrixXd inverse = (rows.transpose() * rows).completeOrthogonalDecomposition().pseudoInverse();
  const Eigen::VectorXd found = inverse * (rows.transpose() * forces);
  const double left_n = (forces - rows * found).norm() /
                        std::sqrt(static_cast<double>(in_plane * runs - (unknowns - in_plane))),
               error_n = std::sqrt(inverse(0, 0)) * std::max(left_n, sensed.noise_n / std::sqrt(samples));
  return found[0] > std::max(surely * error_n, least_share * sensed.press_n);
}

}  // namespace

AirRuns runs_in_the_air(const RecordedTrial& trial, const std::vector<StillRun>& runs, double noise_n,
                        double press_n) {
  const TrialSenses sensed(trial, noise_n, press_n);
  const bool tells_height = sensed.tell_height();
  std::vector<FingerPlace> places;
  std::vector<MovingRun> moving;
  std::optional<LowPhase> last;
  FingerPlace by_height = FingerPlace::unknown;
  bool rubs = false, keeps_height_at_once = false;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const LowPhase phase(sensed, runs[r]);
    if (!last || *last != phase) {  // of whose still parts one after the other comes
      by_height = tells_height ? place_by_height(sensed, phase) : FingerPlace::unknown;
      rubs = rubs_within(sensed, phase);
      last = phase;
    }
    places.push_back(by_height);
    if (by_height == FingerPlace::plate) {
      keeps_height_at_once = keeps_height_at_once || (!rubs && falls_at_once(sensed, phase));
      continue;
    }
    if (const auto one = moved_along(sensed, runs[r], r)) moving.push_back(*one);
    if (rubs) places[r] = FingerPlace::plate;
  }
  if (opposes_motion(sensed, moving)) {
    for (const MovingRun& one : moving) places[one.run] = FingerPlace::plate;
  }
  AirRuns found;
  found.falls_at_once = keeps_height_at_once;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (places[r] == FingerPlace::air) found.surely.push_back(runs[r]);
    if (places[r] == FingerPlace::unknown) found.perhaps.push_back(runs[r]);
    found.presses_on = found.presses_on || places[r] == FingerPlace::plate;
  }
  return found;
}

}  // namespace fingerpad
