#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "friction/pad_profile.hpp"
#include "fuzz/entries.hpp"
#include "fuzz/input_file.hpp"
#include "fuzz/promise.hpp"
#include "motion/recording.hpp"
#include "scene/pad_profile_file.hpp"
#include "scene/scene_file.hpp"
#include "trace/trace.hpp"

namespace fingerpad::test {

void fuzz_scene(std::string_view bytes) {
  const std::string path = "/nowhere/scene.toml";
  SceneFile file;
  try {
    file = read_scene_text(std::string(bytes), path);
  } catch (const Error&) {
    return;
  }
  promise(!file.jobs.empty(), "a scene has a job");
  std::size_t left = 4;  // of a large set
  for (const SceneJob& job : file.jobs) {
    if (!job.error.empty()) continue;
    if (left-- == 0) break;
    // The trace keeps a scene as text: what was read must be readable again, and give the same text.
    const SceneFile again = read_scene_text(job.scene.text, path, Unread::passed_over);
    promise(!again.is_set && again.jobs.size() == 1, "a job's text is a plain scene");
    promise(again.scene.text == job.scene.text, "a job's text gives itself");
    promise(again.scene.name == job.scene.name, "a job's text keeps the name");
  }
}

namespace {

/// A recording in a laboratory's words.
RecordingFormat laboratory_format() {
  RecordingFormat format;
  format.headers = {"Zeit (ms)", "X", "Y", "Z"};
  format.headers.back() = "Fz";
  format.metres_per_unit = 1e-3;
  format.seconds_per_unit = 1e-3;
  format.dialect.decimal = ',';
  format.reads_normal_force = true;
  return format;
}

void check_motion(const Motion& motion) {
  const auto rows = static_cast<Eigen::Index>(motion.t_s.size());
  promise(rows > 0 && motion.p_WQ.cols() == rows, "every time has a position");
  promise(motion.p_WQ.allFinite(), "positions are finite");
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    promise(std::isfinite(motion.t_s[i]), "times are finite");
    promise(i == 0 || motion.t_s[i] > motion.t_s[i - 1], "times increase");
  }
  promise(motion.direction_W.cols() == 0 || motion.direction_W.cols() == rows, "directions for all or none");
  for (Eigen::Index i = 0; i < motion.direction_W.cols(); ++i) {
    promise(std::abs(motion.direction_W.col(i).norm() - 1) < 1e-9, "directions are units");
  }
  for (const double force_n : motion.normal_force_n)
    promise(std::abs(force_n) <= 1e6, "forces are a finger's");
}

/// A recording with a clock of its own can be smoothed, and stays finite.
void refine(const Motion& motion) {
  const RecordingClock clock = recording_clock(motion.t_s);
  promise(clock.rate_hz >= 0, "a clock has a rate");
  if (clock.rate_hz < 1 || clock.rate_hz > 1e6) return;  // refused by load_motion
  Motion even = evenly_sampled(motion, clock);
  estimate_velocity(even, 1e-4, clock.rate_hz);
  smooth(even, 0.1 * clock.rate_hz, clock.rate_hz);
  promise(even.p_WQ.allFinite() && even.velocity_W.allFinite(), "what is smoothed is finite");
}

}  // namespace

void fuzz_motion(std::string_view bytes) {
  const InputFile file(bytes, ".csv");
  for (RecordingFormat format : {RecordingFormat(), laboratory_format()}) {
    try {
      const Motion motion = read_motion_csv(file.path(), format);
      check_motion(motion);
      refine(motion);
    } catch (const Error&) {
      continue;
    }
  }
}

void fuzz_profile(std::string_view bytes) {
  PadProfile profile;
  try {
    profile = read_profile_text(std::string(bytes), "pad.toml");
  } catch (const Error&) {
    return;
  }
  constexpr double right_angle = std::numbers::pi / 2;
  for (const double share : {0.0, 0.5, 1.0}) {
    const double lateral = profile.lateral_axis_at(share * right_angle);
    const double longitudinal = profile.longitudinal_axis_at(share * right_angle);
    promise(lateral > 0 && std::isfinite(lateral), "the lateral axis is there at any angle");
    promise(longitudinal > 0 && std::isfinite(longitudinal), "the longitudinal axis is there at any angle");
  }
  promise(profile.mu_static > 0 && std::isfinite(profile.mu_static), "mu is positive");
}

void fuzz_trace_csv(std::string_view bytes) {
  const InputFile file(bytes, ".csv");
  if (is_hdf5(file.path())) return;  // see fuzz_trace_hdf5
  try {
    const Trace trace = read_trace(file.path());
    for (const TickRecord& row : trace.rows) promise(std::isfinite(row.t_s), "times are finite");
  } catch (const Error&) {
    return;
  }
}

}  // namespace fingerpad::test
