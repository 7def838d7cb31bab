#include "study/press_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace fingerpad {
namespace {

constexpr double least_own_rms_m = 2e-5;  // of a trial's height: else it does not move, and none was measured
constexpr double least_spread = 0.1;      // standard deviation of ln n within trials
// Height that the force does not explain says nothing of the pad: the hand moves, or the plate is not square.
constexpr double least_explained = 0.5;

/// Sums over a subject's trials, for depth = d n^w with one w, and a d of each trial: trials that differ by
/// how the finger lies, at other loads, would else pass for another exponent.
struct Presses {
  double height2 = 0, by_load = 0;    // the heights' squares; what each trial's d explains of them
  double depth_load = 0, load = 0;    // of d
  double bend_m = 0;                  // of what is left beside n^w along n^w ln n
  double bend_depth = 0, depth2 = 0;  // the same by each trial's d
  double load2 = 0, groups = 0;
  long samples = 0, trials = 0;

  /// @param m  sums of (depth, n^w, n^w ln n) with themselves
  void add(const Mat3& m, int times) {
    height2 += times * m(0, 0);
    if (!(m(1, 1) > 0)) return;
    const double depth = m(0, 1) / m(1, 1), left = m(0, 2) - depth * m(1, 2),
                 left2 = m(2, 2) - m(1, 2) * m(1, 2) / m(1, 1);
    depth_load += times * m(0, 1);
    load += times * m(1, 1);
    by_load += times * depth * m(0, 1);
    if (!(left2 > 0)) return;
    bend_m += times * left;
    bend_depth += times * depth * left;
    depth2 += times * depth * depth * left2;
  }
  double depth_m() const { return load > 0 ? depth_load / load : 0; }
  /// How much larger w is than the one that the sums were taken about.
  double step() const { return depth2 > 0 ? bend_depth / depth2 : 0; }
  double explained() const { return by_load + step() * bend_depth; }
};

bool has_height(const TrialEvidence& trial) {
  return trial.press(0, 0) > least_own_rms_m * least_own_rms_m * static_cast<double>(trial.press_groups);
}

}  // namespace

std::optional<double> own_depth_at_1_n_m(const TrialEvidence& trial) {
  const double groups = static_cast<double>(trial.press_groups), term_2 = trial.press(1, 1);
  if (!has_height(trial) || !(trial.press_load_2 > least_spread * least_spread * groups) || !(term_2 > 0))
    return std::nullopt;
  const double depth_m = trial.press(0, 1) / term_2;
  if (!(depth_m > 0) || depth_m * trial.press(0, 1) < least_explained * trial.press(0, 0))
    return std::nullopt;
  return depth_m;
}

PressFit fit_press(const std::vector<TrialEvidence>& trials, const std::vector<int>& times, double about) {
  constexpr double least_rms_m = 5e-5;
  constexpr double least_exponent = 0.5, most_exponent = 10;  // of n over the depth
  PressFit fit;
  std::map<int, Presses> subjects;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (times[i] == 0 || !has_height(trials[i])) continue;
    Presses& own = subjects[trials[i].subject];
    own.add(trials[i].press, times[i]);
    own.load2 += times[i] * trials[i].press_load_2;
    own.groups += static_cast<double>(times[i] * trials[i].press_groups);
    own.samples += times[i] * trials[i].press_samples;
    own.trials += times[i];
  }
  std::erase_if(subjects, [](const auto& one) {
    return !(one.second.height2 > least_rms_m * least_rms_m * one.second.groups);
  });
  const auto count = static_cast<double>(subjects.size());
  double height2 = 0, explained = 0, groups = 0, load2 = 0;
  double exponent = 0;
  bool is_settled = true;
  for (const auto& [subject, own] : subjects) {
    groups += own.groups;
    load2 += own.load2;
    fit.samples += own.samples;
    fit.trials += own.trials;
    height2 += own.height2;
    explained += own.explained();
    // Far from the exponent the height may seem to fall with n^w: then w is on the other side.
    constexpr double most_step = 1.5;
    const double least = about / most_step, most = about * most_step;
    const double next =
        own.depth_m() > 0 ? std::clamp(about + own.step(), least, most) : (own.bend_m > 0 ? most : least);
    fit.depth_at_1_n_m += std::max(0.0, own.depth_m()) / count;
    exponent += next / count;
    is_settled = is_settled && own.depth_m() > 0;
  }
  if (subjects.empty()) {
    fit.refusal =
        "no press is found in which the finger moves along the plate's normal: no depth is measured, or the "
        "times have another unit";
    return fit;
  }
  if (!(load2 > least_spread * least_spread * groups)) {
    fit.refusal = "the normal force hardly changes within a trial: it takes loads that differ by a tenth";
    return fit;
  }
  if (explained > least_explained * height2) fit.exponent = exponent;
  if (!is_settled || !(fit.exponent > 0)) {
    fit.refusal = "the finger's height does not follow the normal force";
  } else if (fit.exponent * most_exponent < 1 || fit.exponent * least_exponent > 1) {
    fit.refusal = fmt::format(
        "the finger's height follows the normal force with an exponent of {:.3g}; a pad's is {} to {}",
        1 / fit.exponent, least_exponent, most_exponent);
  }
  return fit;
}

}  // namespace fingerpad
