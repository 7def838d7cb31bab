#include "study/height_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/number_text.hpp"
#include "study/named_trials.hpp"
#include "study/pad_axes.hpp"
#include "study/press_and_air.hpp"
#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

/// The middle of some of a trial's places, axis by axis.
Vec3 middle_of(const Points& places_W, const std::vector<Eigen::Index>& samples) {
  Vec3 middle_W;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> along;
    along.reserve(samples.size());
    for (const Eigen::Index i : samples) along.push_back(places_W(axis, i));
    middle_W[axis] = median_of(along);
  }
  return middle_W;
}

/// From where the finger is in the air to where it presses; not a number where it never does one of them for
/// long.
Vec3 way_to_press_W(const RecordedTrial& trial) {
  const double press_n = pressing_n(trial);
  const Vec3 none = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  if (!(press_n > least_normal_force_n)) return none;
  auto [pressing, airborne] = press_and_air(along_normal_n(trial), press_n);
  for (std::vector<Eigen::Index>* samples : {&pressing, &airborne}) {
    std::erase_if(*samples, [&](Eigen::Index i) {
      return trial.origin[static_cast<std::size_t>(i)] == SampleOrigin::missing;
    });
    if (!last_long(*samples, trial.rate_hz)) return none;
  }
  const Points& places_W = trial.seen_W();
  return middle_of(places_W, pressing) - middle_of(places_W, airborne);
}

enum class Landing { untold, downwards, upwards };

/// A plate that is not quite level, or a finger that yields as it lands, is no mirror.
Landing landing_of(const RecordedTrial& trial) {
  constexpr double least_m = 1e-3, steepest = 0.2;
  const Vec3 way_W = way_to_press_W(trial);
  const double up_m = way_W.dot(trial.normal_W);
  const double clear_m = least_m + steepest * (way_W - up_m * trial.normal_W).norm();
  return up_m > clear_m ? Landing::upwards : up_m < -clear_m ? Landing::downwards : Landing::untold;
}

std::string rise_words(const RecordedTrial& trial) {
  return fmt::format("its finger is {} mm higher where it presses than in the air",
                     rounded_text(1e3 * way_to_press_W(trial).dot(trial.normal_W), 3));
}

}  // namespace

std::vector<std::string> height_doubts(FileTrials own, const std::vector<RecordedTrial>& all) {
  std::vector<const RecordedTrial*> upwards;
  bool others_are_lower = false;
  for (const RecordedTrial& trial : own) {
    const Landing landing = landing_of(trial);
    if (landing == Landing::upwards) upwards.push_back(&trial);
    others_are_lower = others_are_lower || landing == Landing::downwards;
  }
  if (2 * upwards.size() > own.size())
    return {fmt::format(
        "{}: {}: is its height mirrored (z, where the normal is 0,0,1)? Then turn that column's sign; "
        "normal_stiffness_n_per_m and normal_exponent go by it, friction does not",
        upwards.front()->file, rise_words(*upwards.front()))};
  std::vector<std::string> doubts;
  doubts.reserve(upwards.size());
  for (const RecordedTrial* trial : upwards)
    doubts.push_back(
        fmt::format("{}: {}{}: is its height mirrored? normal_stiffness_n_per_m and normal_exponent go by "
                    "it; --leave-out '{}' leaves it out",
                    trial_name(*trial), rise_words(*trial),
                    others_are_lower ? ", and other trials' is lower" : "", option_name(*trial, all)));
  return doubts;
}

}  // namespace fingerpad
