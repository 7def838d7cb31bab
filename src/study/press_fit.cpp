#include "study/press_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>

namespace fingerpad {
namespace {

constexpr double least_own_rms_m = 2e-5;  // of a trial's height: else it does not move, and none was measured
constexpr double least_spread = 0.1;      // standard deviation of ln n within trials
// Height that the force does not explain says nothing of the pad: the hand moves, or the plate is not square.
constexpr double least_explained = 0.5;

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
  /// Sums over a subject's trials.
  struct Presses {
    Mat3 sums = Mat3::Zero();
    double load2 = 0, groups = 0;
    long samples = 0, trials = 0;
  };
  std::map<int, Presses> subjects;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (times[i] == 0 || !has_height(trials[i])) continue;
    Presses& own = subjects[trials[i].subject];
    own.sums += times[i] * trials[i].press;
    own.load2 += times[i] * trials[i].press_load_2;
    own.groups += static_cast<double>(times[i] * trials[i].press_groups);
    own.samples += times[i] * trials[i].press_samples;
    own.trials += times[i];
  }
  std::erase_if(subjects, [](const auto& one) {
    return !(one.second.sums(0, 0) > least_rms_m * least_rms_m * one.second.groups);
  });
  const auto count = static_cast<double>(subjects.size());
  double height2 = 0, explained = 0, groups = 0, load2 = 0;
  double exponent = 0;
  bool is_settled = true;
  for (const auto& [subject, own] : subjects) {
    const Mat3& m = own.sums;
    groups += own.groups;
    load2 += own.load2;
    fit.samples += own.samples;
    fit.trials += own.trials;
    const Eigen::Matrix2d normal = m.bottomRightCorner<2, 2>();
    const Vec2 right = m.bottomLeftCorner<2, 1>();
    const Vec2 found = normal.ldlt().solve(right);
    height2 += m(0, 0);
    explained += found.dot(right);
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
