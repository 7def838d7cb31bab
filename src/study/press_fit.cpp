#include "study/press_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace fingerpad {
namespace {

constexpr double least_own_rms_m = 2e-5;  // of a trial's height: else it does not move, and none was measured
constexpr double least_spread = 0.1;      // standard deviation of ln n within trials
// Height that the force does not explain says nothing of the pad: the hand moves, or the plate is not square.
constexpr double least_explained = 0.5;

/// Sums of (depth, n^w, n^w ln n) with themselves, of a trial that counts so many times.
struct TrialPress {
  Mat3 sums;
  double groups;
  int times;

  double depth_m() const { return sums(0, 1) / sums(1, 1); }
  /// What its own d and bend leave of the depths' squares.
  double left_m2() const {
    const double bend_m = sums(0, 2) - depth_m() * sums(1, 2),
                 bend2 = sums(2, 2) - sums(1, 2) * sums(1, 2) / sums(1, 1);
    return sums(0, 0) - depth_m() * sums(0, 1) - (bend2 > 0 ? bend_m * bend_m / bend2 : 0);
  }
};

/// A subject's presses, for depth = d n^w with one w, and a d of each trial about the subject's: trials that
/// differ by how the finger lies, at other loads, would else pass for another exponent.
struct Presses {
  std::vector<TrialPress> each;
  double height2 = 0, load2 = 0, groups = 0;
  long samples = 0, trials = 0;

  /// By how much the trials' d differ beyond chance, squared, in units of the depths' variance: moments, as
  /// DerSimonian & Laird 1986, eq. 9, have them.
  double spread2() const {
    double left_m2 = 0, free = 0, count = 0, load = 0, load_2 = 0, depth_load = 0;
    for (const TrialPress& one : each) {
      left_m2 += one.times * std::max(0.0, one.left_m2());
      free += one.times * std::max(0.0, one.groups - 3);
      count += one.times;
      load += one.times * one.sums(1, 1);
      load_2 += one.times * one.sums(1, 1) * one.sums(1, 1);
      depth_load += one.times * one.sums(0, 1);
    }
    if (!(free > 0) || !(left_m2 > 0) || !(load * load > load_2)) return 0;
    const double usual = depth_load / load, variance = left_m2 / free;
    double apart = 0;
    for (const TrialPress& one : each)
      apart += one.times * one.sums(1, 1) * (one.depth_m() - usual) * (one.depth_m() - usual);
    return std::max(0.0, (apart / variance - (count - 1)) / (load - load_2 / load));
  }

  /// d [m], and d times how much larger w is than the one that the sums were taken about, by generalized
  /// least squares; and what these explain of the heights' squares.
  struct Solution {
    Vec2 found;
    double explained;
  };
  Solution solve() const {
    const double spread = spread2();
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Vec2 right = Vec2::Zero(), plain = Vec2::Zero();
    for (const TrialPress& one : each) {
      const Vec2 by_load = one.sums.block<2, 1>(1, 1), by_depth = one.sums.block<2, 1>(1, 0);
      const double less = spread / (1 + spread * one.sums(1, 1));
      normal += one.times * (one.sums.bottomRightCorner<2, 2>() - less * by_load * by_load.transpose());
      right += one.times * (by_depth - less * by_load * one.sums(0, 1));
      plain += one.times * by_depth;
    }
    const Vec2 found = normal.ldlt().solve(right);
    return {found, found.dot(plain)};
  }
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
    own.height2 += times[i] * trials[i].press(0, 0);
    if (trials[i].press(1, 1) > 0)
      own.each.push_back({trials[i].press, static_cast<double>(trials[i].press_groups), times[i]});
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
    const auto [found, explained_m2] = own.solve();
    explained += explained_m2;
    // Far from the exponent the height may seem to fall with n^w: then w is on the other side.
    constexpr double most_step = 1.5;
    const double least = about / most_step, most = about * most_step;
    const double next =
        found[0] > 0 ? std::clamp(about + found[1] / found[0], least, most) : (found[1] > 0 ? most : least);
    fit.depth_at_1_n_m += std::max(0.0, found[0]) / count;
    exponent += next / count;
    is_settled = is_settled && found[0] > 0;
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
