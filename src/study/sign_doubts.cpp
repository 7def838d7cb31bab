#include "study/sign_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "motion/driving_share.hpp"
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

/// What a trial's forces do on its finger (driving_share.hpp).
struct Drive {
  Vec3 by_axis;
  double share = 0;
};

std::vector<Drive> drives_of(FileTrials trials, double delay_s) {
  std::vector<Drive> drives;
  for (const RecordedTrial& trial : trials) {
    const SameMoments both = same_moments(trial, delay_s);
    drives.push_back({driving_share_by_axis(both.position_W, both.force_W, trial.rate_hz),
                      driving_share(both.position_W, both.force_W, trial.rate_hz)});
  }
  return drives;
}

/// The middle of what trials have of it; not a number where none has.
template <typename Of>
double usual_of(FileTrials trials, const std::vector<Drive>& drives, const Of& of) {
  return usual(trials, [&](const RecordedTrial& trial) {
    return of(drives[static_cast<std::size_t>(&trial - trials.data())]);
  });
}

/// No turn of a sensor puts right what one axis has of a mirror.
void refuse_mirrored_axis(FileTrials trials, const std::vector<Drive>& drives) {
  Vec3 share;
  for (int axis = 0; axis < 3; ++axis)
    share[axis] = usual_of(trials, drives, [axis](const Drive& drive) { return drive.by_axis[axis]; });
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
  const std::vector<Drive> drives = drives_of(trials, delay_s);
  refuse_mirrored_axis(trials, drives);
  if (usual_of(trials, drives, [](const Drive& drive) { return drive.share; }) > most_driving_share)
    throw refused(
        file,
        "its force drives the finger along its way, and friction holds a finger back: fx and fy have the "
        "wrong sign while the normal force has the right one. --force-on turns all three, --sensor-turned "
        "0,0,0,1 (half a turn about z) fx and fy alone. A force that comes over 50 ms after the position "
        "looks like it too: then say --delay 7ms");
}

}  // namespace fingerpad
