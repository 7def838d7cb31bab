#include "device/recorded_finger.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "device/device_table.hpp"

namespace fingerpad {
namespace {

/// The rate at which `replay` would follow the scene's motion.
double rate_of_motion_hz(const Scene& scene) {
  return scene.motion.has_own_rate() ? load_motion(scene).path.rate_hz() : scene.motion.rate_hz;
}

}  // namespace

RecordedFinger::RecordedFinger(const DeviceSetup& setup) : RecordedFinger(setup, load_motion(setup.scene)) {}

RecordedFinger::RecordedFinger(const DeviceSetup& setup, const LoadedMotion& motion)
    : path_(motion.path.with_rate(setup.scene.motion.rate_hz)),
      changes_(motion.changes),
      warnings_(motion.warnings) {
  const std::string& file = setup.scene.motion.file;
  words_ = fmt::format("{}, {} s, {} ticks", file.empty() ? "a scripted motion" : file,
                       rounded_text(path_.end_s() - path_.start_s(), 4), path_.tick_count());
}

SampleParts RecordedFinger::gives() const noexcept {
  return {.directions = path_.turns(),
          .attitudes = path_.has_attitudes(),
          .velocities = path_.has_velocity(),
          .pushes = path_.was_in_hand()};
}

FingerSample RecordedFinger::advance(double) noexcept {
  if (next_ < path_.tick_count()) return path_.at(next_++);
  ended_.store(true, std::memory_order_relaxed);
  FingerSample last = path_.at(path_.tick_count() - 1);
  last.velocity_W.reset();
  last.normal_force_n.reset();
  return last;
}

DeviceEntry recorded_device() noexcept {
  return {.name = "recorded",
          .doc = "the scene's own motion (a table, a trace, a script), in real time",
          .make = [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<RecordedFinger>(setup);
          },
          .rate_hz = rate_of_motion_hz,
          .refuse =
              [](const Scene& scene, const DeviceLink&) {
                if (!scene.motion.given()) load_motion(scene);  // which says what is missing
              }};
}

}  // namespace fingerpad
