#include "study/trial_drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/driving_share.hpp"
#include "study/file_trials.hpp"
#include "study/pad_axes.hpp"
#include "study/press_and_air.hpp"
#include "study/six_axis_sensor.hpp"

namespace fingerpad {
namespace {

/// Forces of the samples that press with half of what their trial presses with, or more: by how much they
/// differ from those in the air. The others are no numbers: no friction acts on a finger in the air, and the
/// sensor's offset would be taken for one.
Points pressed_force_W(const RecordedTrial& trial) {
  const double press_n = pressing_n(trial), none = std::numeric_limits<double>::quiet_NaN();
  if (!(press_n > least_normal_force_n)) return Points::Constant(3, trial.samples(), none);
  const PressAndAir samples = press_and_air(along_normal_n(trial), press_n);
  Vec3 offset_W = Vec3::Zero();
  if (last_long(samples.air, trial.rate_hz)) {
    for (const Eigen::Index i : samples.air) offset_W += trial.force_W.col(i);
    offset_W /= static_cast<double>(samples.air.size());
  }
  Points forces_W = Points::Constant(3, trial.samples(), none);
  for (const Eigen::Index i : samples.press) forces_W.col(i) = trial.force_W.col(i) - offset_W;
  return forces_W;
}

/// A trial's positions and pressing forces of the same moments, where force lags position by a delay.
struct SameMoments {
  Points position_W, force_W;
};

SameMoments same_moments(const RecordedTrial& trial, double delay_s) {
  const Eigen::Index n = trial.samples(), most = n / 2,
                     lag = std::clamp<Eigen::Index>(std::lround(delay_s * trial.rate_hz), -most, most),
                     count = n - std::abs(lag);
  return {finger_W(trial).middleCols(std::max<Eigen::Index>(-lag, 0), count),
          pressed_force_W(trial).middleCols(std::max<Eigen::Index>(lag, 0), count)};
}

}  // namespace

Drive drive_of(const RecordedTrial& trial, double delay_s) {
  const SameMoments both = same_moments(trial, delay_s);
  return {driving_share_by_axis(both.position_W, both.force_W, trial.rate_hz),
          driving_share(both.position_W, both.force_W, trial.rate_hz)};
}

}  // namespace fingerpad
