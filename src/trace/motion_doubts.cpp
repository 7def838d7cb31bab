#include "trace/motion_doubts.hpp"

#include "base/number_text.hpp"
#include "motion/driving_share.hpp"
#include "motion/pressed_force.hpp"

namespace fingerpad {

void refuse_wild_rate(const MotionReading& reading, double least_hz) {
  const RecordingClock& clock = reading.clock;
  constexpr double most_hz = 1e6;
  if (clock.rate_hz == 0 || (clock.rate_hz >= least_hz && clock.rate_hz <= most_hz)) return;
  throw refused(
      reading.settings.file_path,
      fmt::format("its own rate is {}, and ticks go at 1 to {:.0f} Hz: give rate_hz (is its time in "
                  "seconds? if not, say time_unit)",
                  clock_text(clock), most_hz));
}

void warn_of_odd_steps(MotionReading& reading) {
  const RecordingClock& clock = reading.clock;
  if (clock.odd_steps == 0) return;
  reading.warn(
      fmt::format("its clock is irregular: {} of {} steps are off by more than half, the longest "
                  "is {} ms at t = {} s; in between the finger goes straight",
                  clock.odd_steps, clock.steps, rounded_text(1e3 * clock.longest_s, 3),
                  rounded_text(clock.longest_at_s, 6)));
}

void warn_of_odd_force(MotionReading& reading) {
  const std::vector<double>& forces_n = reading.motion.normal_force_n;
  if (forces_n.empty()) return;
  constexpr double hardest_n = 40;
  const double usual_n = pressed_median_n(forces_n);
  if (usual_n < 0)
    reading.warn(
        fmt::format("its measured normal force is {} N where it presses, and one below 0 presses nothing: "
                    "the finger feels no force there, nor friction; where it is the force on the surface, as "
                    "a plate measures it, say force_on = \"plate\" in [motion]",
                    rounded_text(usual_n, 3)));
  if (usual_n == 0)
    reading.warn(
        "its measured normal force is 0 throughout, so that no force acts: is its column the right one?");
  if (usual_n > hardest_n)
    reading.warn(
        fmt::format("its measured normal force is {} N where it presses, harder than a finger rubs: "
                    "forces are read as newtons",
                    rounded_text(usual_n, 3)));
}

void warn_of_driving_force(MotionReading& reading) {
  const Motion& motion = reading.motion;
  if (motion.force_W_n.cols() == 0 || reading.clock.rate_hz == 0) return;
  if (driving_share(motion.p_WQ, motion.force_W_n, reading.clock.rate_hz) > most_driving_share)
    reading.warn(
        "its measured force drives the finger along its way, and friction holds a finger back: is it that on "
        "the surface (force_on = \"plate\")?");
}

}  // namespace fingerpad
