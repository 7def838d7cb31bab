#include "study/trial_drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/driving_share.hpp"
#include "study/file_trials.hpp"
#include "study/pad_axes.hpp"
#include "study/six_axis_sensor.hpp"

namespace fingerpad {
namespace {

/// Forces of the samples that press with half of what their trial presses with, or more: by how much they
/// differ from those in the air. The others are no numbers: no friction acts on a finger in the air, and the
/// sensor's offset would be taken for one.
Points pressed_force_W(const RecordedTrial& trial) {
  constexpr double pressed = 0.5, in_air = 0.25;  // of the trial's press
  constexpr double least_air_s = 0.02;
  const double press_n = pressing_n(trial), none = std::numeric_limits<double>::quiet_NaN();
  if (!(press_n > least_normal_force_n)) return Points::Constant(3, trial.samples(), none);
  const Eigen::RowVectorXd along_n = along_normal_n(trial);
  Vec3 air_W = Vec3::Zero();
  double air_count = 0;
  for (Eigen::Index i = 0; i < along_n.size(); ++i) {
    if (!(along_n[i] < in_air * press_n)) continue;
    air_W += trial.force_W.col(i);
    ++air_count;
  }
  const bool has_air = air_count >= std::max(1.0, least_air_s * trial.rate_hz);
  Points forces_W = trial.force_W.colwise() - (has_air ? Vec3(air_W / air_count) : Vec3(Vec3::Zero()));
  for (Eigen::Index i = 0; i < along_n.size(); ++i)
    if (!(along_n[i] >= pressed * press_n)) forces_W.col(i).setConstant(none);
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
