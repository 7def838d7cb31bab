#include "study/sign_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "motion/driving_share.hpp"
#include "study/six_axis_sensor.hpp"

namespace fingerpad {
namespace {

/// Forces of the samples that press with half of what their trial does or more, from those in the air; the
/// others are no numbers: in the air there is no friction, but the sensor's offset on a finger that moves.
Points pressed_force_W(const RecordedTrial& trial) {
  constexpr double pressed = 0.5, in_air = 0.25;  // of the trial's press
  constexpr Eigen::Index fewest_in_air = 20;
  const double press_n = pressing_n(trial), none = std::numeric_limits<double>::quiet_NaN();
  if (!(press_n > 0) || !presses(trial)) return Points::Constant(3, trial.samples(), none);
  const Eigen::RowVectorXd along_n = along_normal_n(trial);
  Vec3 air_W = Vec3::Zero();
  Eigen::Index in_air_count = 0;
  for (Eigen::Index i = 0; i < along_n.size(); ++i) {
    if (!(along_n[i] < in_air * press_n)) continue;
    air_W += trial.force_W.col(i);
    ++in_air_count;
  }
  const Vec3 offset_W =
      in_air_count < fewest_in_air ? Vec3::Zero() : Vec3(air_W / static_cast<double>(in_air_count));
  Points forces_W = trial.force_W.colwise() - offset_W;
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

/// No turn of a sensor puts right what one axis has of a mirror.
void refuse_mirrored_axis(FileTrials trials, double delay_s) {
  Vec3 share;
  for (int axis = 0; axis < 3; ++axis) {
    share[axis] = usual(trials, [&](const RecordedTrial& trial) {
      const SameMoments both = same_moments(trial, delay_s);
      return driving_share_by_axis(both.position_W, both.force_W, trial.rate_hz)[axis];
    });
  }
  for (int axis = 0; axis < 3; ++axis) {
    const bool others_brake = (share.array() < -most_driving_share).any();
    if (!(share[axis] > most_driving_share) || !others_brake) continue;
    throw refused(
        trials.front().file,
        fmt::format("along {0} alone its force drives the finger, and friction holds a finger back: "
                    "the force or the position along {0} is mirrored; turn that column's sign",
                    "xyz"[axis]));
  }
}

}  // namespace

void ask_for_signs(FileTrials trials, const MeasurementFormat& format, double delay_s) {
  constexpr double surely_n = 0.15;  // a sensor's offset may be below 0 where nothing presses
  const std::string& file = trials.front().file;
  const double press_n = usual(trials, pressing_n);
  if (press_n < -surely_n)
    throw refused(
        file, fmt::format(
                  "its force is {} N along the plate's normal where it presses, and a plate pushes a "
                  "finger away: say {} if it is the force on the {}, or give the normal (nx, ny, nz) or how "
                  "the sensor stands (--sensor-turned)",
                  rounded_text(press_n, 3), format.force_on_plate ? "--force-on finger" : "--force-on plate",
                  format.force_on_plate ? "finger" : "plate"));
  if (!trials.front().lacks.empty()) return;  // no friction, whose sign could be wrong
  refuse_mirrored_axis(trials, delay_s);
  const double drives = usual(trials, [delay_s](const RecordedTrial& trial) {
    const SameMoments both = same_moments(trial, delay_s);
    return driving_share(both.position_W, both.force_W, trial.rate_hz);
  });
  if (drives > most_driving_share)
    throw refused(
        file,
        "its force drives the finger along its way, and friction holds a finger back: fx and fy have the "
        "wrong sign while the normal force has the right one. --force-on turns all three, --sensor-turned "
        "0,0,0,1 (half a turn about z) fx and fy alone. A force that comes over 50 ms after the position "
        "looks like it too: then say --delay 7ms");
}

}  // namespace fingerpad
