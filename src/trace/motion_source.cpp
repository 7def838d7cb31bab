#include "trace/motion_source.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "motion/placed_motion.hpp"
#include "scene/scene_reader.hpp"
#include "touch/mesh_store.hpp"
#include "trace/made_motion.hpp"
#include "trace/motion_doubts.hpp"
#include "trace/motion_reading.hpp"

namespace fingerpad {
namespace {

/// The rate of the ticks.
double settled_rate_hz(MotionReading& reading) {
  const MotionSettings& settings = reading.settings;
  const RecordingClock& clock = reading.clock;
  if (settings.rate_given || settings.automatic_rate) return settings.rate_hz;
  if (clock.rate_hz == 0) return settings.rate_hz;  // one sample
  constexpr double fair_hz = 100;
  reading.note(fmt::format("no rate_hz: ticks at the file's own {}{}", clock_text(clock),
                           clock.rate_hz < fair_hz
                               ? ", few for friction; with rate_hz = 1000 they go between its samples too"
                               : ""));
  return clock.rate_hz;
}

}  // namespace

LoadedMotion load_motion(const Scene& scene) {
  MeshStore meshes(1);
  return load_motion(scene, meshes);
}

LoadedMotion load_motion(const Scene& scene, MeshStore& meshes) {
  const MotionSettings& settings = scene.motion;
  if (!settings.given()) {
    constexpr const char* why = "the scene has no motion to follow; give [motion] a 'file' or a 'kind'";
    if (!scene.path.empty()) throw refused(scene.path, why);
    throw refused(scene.parts.empty() ? scene.name : scene.parts.front().mesh,
                  std::string(why) + " (a mesh by itself has none: name a scene)");
  }
  if (settings.scripted) return at_chosen_rate(scene, scripted_motion(scene));
  if (settings.laid) return laid_at_chosen_rate(scene, meshes);
  MotionReading reading{scene, settings, {}, {}, false, false, {}, {}, {}};
  read_file(reading);
  reading.clock = recording_clock(reading.motion.t_s);
  warn_of_named_units(reading);
  warn_of_one_sample(reading);
  warn_of_leaps(reading);
  warn_of_slow_clock(reading);
  warn_of_quick_clock(reading);
  if (settings.has_own_rate() || is_refined(settings))
    refuse_wild_rate(reading, settings.has_own_rate() ? 1 : 0);
  const double rate_hz = settled_rate_hz(reading);
  if (settings.has_own_rate()) keep_last_sample(reading.motion, reading.clock);
  if (scene.hand && settings.has_own_rate()) refuse_hand_too_quick(*scene.hand, rate_hz, scene.path);
  if (settings.has_own_rate() || is_refined(settings)) warn_of_odd_steps(reading);
  warn_of_odd_force(reading);
  warn_of_force_unit(reading);
  warn_of_driving_force(reading);
  if (is_refined(settings)) refine(reading);
  if (!settings.placement.is_world()) {
    const MotionPose pose = motion_pose(scene);
    place(reading.motion, pose.rotation, pose.position_m);
  }
  return in_file(settings, [&] {
    return at_chosen_rate(scene, LoadedMotion{{std::move(reading.motion), rate_hz, scene.finger.direction},
                                              reading.notes,
                                              reading.changes,
                                              reading.warnings});
  });
}

FingerPath load_finger_path(const Scene& scene) {
  return load_motion(scene).path;
}

}  // namespace fingerpad
