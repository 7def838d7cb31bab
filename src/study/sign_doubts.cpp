#include "study/sign_doubts.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <vector>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "motion/driving_share.hpp"
#include "study/air_offset.hpp"
#include "study/trial_drive.hpp"

namespace fingerpad {
namespace {

std::vector<Drive> drives_of(FileTrials trials, double delay_s) {
  std::vector<Drive> drives;
  drives.reserve(trials.size());
  for (const RecordedTrial& trial : trials) drives.push_back(drive_of(trial, delay_s));
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
  const std::string& file = trials.front().file;
  const double press_n = usual(trials, pressing_n);
  if (press_n < -surely_presses_n) {
    if (const std::string offset = hiding_offset_words(trials); !offset.empty()) throw refused(file, offset);
    throw refused(
        file, fmt::format(
                  "its force is {} N along the plate's normal where it presses, and a plate pushes a "
                  "finger away: say {} if it is the force on the {}, or give the normal (nx, ny, nz) or how "
                  "the sensor stands (--sensor-turned)",
                  rounded_text(press_n, 3), format.force_on_plate ? "--force-on finger" : "--force-on plate",
                  format.force_on_plate ? "finger" : "plate"));
  }
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
