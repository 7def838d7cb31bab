#include "trace/motion_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "base/unit.hpp"
#include "motion/driving_share.hpp"
#include "motion/field_format.hpp"
#include "motion/placed_motion.hpp"
#include "motion/pressed_force.hpp"
#include "motion/recording.hpp"
#include "scene/scene_reader.hpp"
#include "touch/mesh_store.hpp"
#include "touch/rate_choice.hpp"
#include "trace/trace.hpp"

namespace fingerpad {
namespace {

/// How the finger lay at row i.
void take_direction(const std::string& path, std::size_t i, const TickRecord& row, Motion& motion) {
  if (!(std::abs(row.direction_W.norm() - 1) < 1e-6))
    throw refused(path, fmt::format("row {}: the finger's direction is no unit vector", i + 1));
  motion.direction_W.col(static_cast<Eigen::Index>(i)) = row.direction_W;
}

void take_attitude(const std::string& path, std::size_t i, const TickRecord& row, Motion& motion) {
  if (!(std::abs(row.attitude.norm() - 1) < 1e-6))
    throw refused(path, fmt::format("row {}: the finger's attitude is no unit quaternion", i + 1));
  motion.attitude.emplace_back(row.attitude[0], row.attitude[1], row.attitude[2], row.attitude[3]);
}

/// The finger's way in a trace, as the run's friction was told it: of a hand the encoders' positions.
Motion motion_of_trace(const Trace& trace, const std::string& path, bool reads_normal_force) {
  if (trace.rows.empty()) throw refused(path, "the trace has no rows");
  const auto count = static_cast<Eigen::Index>(trace.rows.size());
  Motion motion;
  motion.p_WQ.resize(3, count);
  if (trace.info.in_hand) motion.push_W_n.resize(3, count);
  if (trace.info.estimated) motion.velocity_W.resize(3, count);
  if (trace.info.turning) motion.direction_W.resize(3, count);
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    const TickRecord& row = trace.rows[i];
    if (i > 0 && !(row.t_s > motion.t_s.back())) {
      throw refused(
          path, fmt::format("row {}: time {} s does not come after {} s", i + 1, row.t_s, motion.t_s.back()));
    }
    const Vec3& place_W = trace.info.in_hand ? row.encoded_W : row.p_WQ;
    std::string fault = sample_fault(row.t_s, place_W);
    if (fault.empty() && reads_normal_force) fault = force_fault(row.normal_force_n);
    if (!fault.empty()) throw refused(path, fmt::format("row {}: {}", i + 1, fault));
    motion.t_s.push_back(row.t_s);
    const auto column = static_cast<Eigen::Index>(i);
    motion.p_WQ.col(column) = place_W;
    if (trace.info.in_hand) motion.push_W_n.col(column) = row.push_W_n;
    if (trace.info.estimated) motion.velocity_W.col(column) = row.velocity_W;
    if (trace.info.turning) take_direction(path, i, row, motion);
    if (trace.info.attitudes) take_attitude(path, i, row, motion);
    if (reads_normal_force) motion.normal_force_n.push_back(row.normal_force_n);
  }
  return motion;
}

/// "t = 'time', x = 'X'; cells parted by ';', decimal ','; positions in mm, times in ms"; empty for the
/// program's own form.
std::string reading_text(const RecordingFormat& format) {
  std::vector<std::string> said;
  std::string columns;
  for (std::size_t k = 0; k < recording_columns.size(); ++k) {
    if (format.headers[k].empty()) continue;
    columns += fmt::format("{}{} is '{}'", columns.empty() ? "" : ", ", recording_columns[k].key,
                           printable(format.headers[k], 60));
  }
  if (!columns.empty()) said.push_back(columns);
  if (format.dialect.separator != ',')
    said.push_back(fmt::format("cells parted by {}", separator_words(format.dialect.separator)));
  if (format.dialect.decimal != '.') said.push_back(fmt::format("decimal mark '{}'", format.dialect.decimal));
  for (const LengthUnit& unit : length_units) {
    if (unit.metres == format.metres_per_unit && unit.metres != 1)
      said.push_back(fmt::format("positions in {}", unit.name));
  }
  for (const TimeUnit& unit : time_units) {
    if (unit.seconds == format.seconds_per_unit && unit.seconds != 1)
      said.push_back(fmt::format("times in {}", unit.name));
  }
  for (const ForceUnit& unit : force_units) {
    if (unit.newtons == format.newtons_per_unit && unit.newtons != 1)
      said.push_back(fmt::format("forces in {}", unit.name));
  }
  return fmt::format("{}", fmt::join(said, "; "));
}

/// A file on its way to what the finger follows, and what is to be told of it.
struct Reading {
  const Scene& scene;
  const MotionSettings& settings;
  Motion motion;
  RecordingClock clock;
  std::vector<SceneChange> changes;
  std::vector<std::string> notes, warnings;

  /// Files are named as the scene names them: what a trace keeps holds no path of one machine.
  void note(const std::string& what) { notes.push_back(fmt::format("{}: {}", settings.file, what)); }
  void warn(const std::string& what) { warnings.push_back(fmt::format("{}: {}", settings.file, what)); }
};

void warn_of_thinned(Reading& reading, std::uint64_t every) {
  if (every <= 1) return;
  reading.warn(fmt::format(
      "is a trace with 1 row in {} ticks (replay --every): between its rows the finger goes straight, so "
      "this is not the motion of its run, nor will the forces be; replay its scene without --every",
      every));
}

void read_file(Reading& reading) {
  const MotionSettings& settings = reading.settings;
  const bool reads_force = settings.format.reads_normal_force;
  const bool hdf5 = is_hdf5(settings.file_path);
  if (hdf5 || (settings.table_key.empty() && is_csv_trace(settings.file_path))) {
    if (!settings.table_key.empty()) {
      throw refused(reading.scene.path,
                    fmt::format("'{}' in [motion] says how a table of text is to be read, and {} is a trace "
                                "(HDF5), which says itself what it holds: leave the key out",
                                settings.table_key, settings.file));
    }
    Trace trace = read_trace(settings.file_path, TraceContents::rows);
    reading.motion = motion_of_trace(trace, settings.file_path, reads_force);
    warn_of_thinned(reading, trace.info.every);
    if (const std::string words = early_end_words(trace); !words.empty()) reading.warn(words);
    reading.changes = std::move(trace.info.changes);
    if (!reading.changes.empty())
      reading.note(fmt::format("with the {} changes of the scene that were made while it was touched",
                               reading.changes.size()));
    return;
  }
  FieldRecording recording = read_field_recording(settings.file_path, settings.format);
  warn_of_thinned(reading, every_of_csv(settings.file_path));
  reading.motion = std::move(recording.motion);
  if (!reads_force) reading.motion.normal_force_n.clear();
  if (reads_force && reading.motion.normal_force_n.empty())
    throw refused(settings.file_path, "holds no normal force, which normal_force = \"measured\" asks for");
  const std::string how = reading_text(recording.read_as);
  if (!how.empty()) reading.note(how);
  for (const std::string& note : recording.notes) reading.note(note);
  for (const std::string& warning : recording.warnings) reading.warn(warning);
}

/// A rate that no ticks and no resampling go at.
void refuse_wild_rate(const Reading& reading, double least_hz) {
  const RecordingClock& clock = reading.clock;
  constexpr double most_hz = 1e6;
  if (clock.rate_hz == 0 || (clock.rate_hz >= least_hz && clock.rate_hz <= most_hz)) return;
  throw refused(
      reading.settings.file_path,
      fmt::format("its own rate is {}, and ticks go at 1 to {:.0f} Hz: give rate_hz (is its time in "
                  "seconds? if not, say time_unit)",
                  clock_text(clock), most_hz));
}

/// The rate of the ticks.
double settled_rate_hz(Reading& reading) {
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

/// Said where the file's clock decides something.
void warn_of_odd_steps(Reading& reading) {
  const RecordingClock& clock = reading.clock;
  if (clock.odd_steps == 0) return;
  reading.warn(
      fmt::format("its clock is irregular: {} of {} steps are off by more than half, the longest "
                  "is {} ms at t = {} s; in between the finger goes straight",
                  clock.odd_steps, clock.steps, rounded_text(1e3 * clock.longest_s, 3),
                  rounded_text(clock.longest_at_s, 6)));
}

bool is_refined(const MotionSettings& settings) {
  return settings.encoder_m > 0 || settings.smoothing_hz > 0;
}

/// What is refused there is refused at the file.
template <typename Work>
auto in_file(const MotionSettings& settings, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw refused(settings.file_path, error.what());
  }
}

void refine(Reading& reading) {
  const MotionSettings& settings = reading.settings;
  const double rate_hz = reading.clock.rate_hz;
  if (rate_hz == 0) return;
  if (settings.smoothing_hz >= rate_hz / 2) {
    throw refused(reading.scene.path,
                  fmt::format("'smoothing_hz' in [motion] is {}; it must be below half of the {} of {}",
                              number_text(settings.smoothing_hz), clock_text(reading.clock), settings.file));
  }
  reading.motion = in_file(settings, [&] { return evenly_sampled(reading.motion, reading.clock); });
  if (settings.encoder_m > 0) {
    estimate_velocity(reading.motion, settings.encoder_m, rate_hz);
    reading.note(fmt::format("velocity by the adaptive window over positions rounded to {} mm, at {} Hz",
                             rounded_text(1e3 * settings.encoder_m, 6), rounded_text(rate_hz, 6)));
  }
  if (!(settings.smoothing_hz > 0)) return;
  const Smoothing smoothing = smooth(reading.motion, settings.smoothing_hz, rate_hz);
  reading.note(
      fmt::format("smoothed without delay (Butterworth, 2nd order, forth and back at {} Hz; {} "
                  "Hz is halved): positions moved by {} mm RMS, at most {} mm",
                  rounded_text(rate_hz, 6), rounded_text(settings.smoothing_hz, 6),
                  rounded_text(1e3 * smoothing.rms_m, 3), rounded_text(1e3 * smoothing.most_m, 3)));
}

/// What takes a motion's own coordinates to the world.
struct MotionPose {
  Mat3 rotation;
  Vec3 position_m;
};

MotionPose pose_of(const Scene& scene) {
  const MotionPlacement& placement = scene.motion.placement;
  if (!placement.in_part) return {placement.rotation, placement.position_m};
  const PartEntry& part = scene.parts.front();
  return {part.rotation * placement.rotation, part.position_m + part.rotation * placement.position_m};
}

LoadedMotion scripted_motion(const Scene& scene) {
  ScriptedMotion motion = *scene.motion.scripted;
  if (!scene.motion.placement.is_world()) {
    const MotionPose pose = pose_of(scene);
    place(motion, pose.rotation, pose.position_m);
  }
  return {{motion, scene.motion.rate_hz, scene.finger.direction}};
}

std::string shape_text(const SurfaceMotion& rub) {
  const double size_mm = 1e3 * rub.size_m;
  if (rub.shape == SurfaceMotion::Shape::line)
    return fmt::format("a line of {} mm", rounded_text(size_mm, 4));
  return fmt::format("a {} of {} mm radius", rub.shape == SurfaceMotion::Shape::circle ? "circle" : "spiral",
                     rounded_text(size_mm, 4));
}

LoadedMotion laid_motion(const Scene& scene, double rate_hz, MeshStore& meshes) {
  const SurfaceMotion& rub = *scene.motion.laid;
  const PartEntry& part = scene.parts.front();
  const double depth_m = pressed_depth_m(scene);
  const auto mesh = meshes.load(part);
  LaidMotion laid;
  try {
    laid = lay_on_surface(*mesh->tree, rub, scene.finger.radius_m, depth_m, rate_hz);
  } catch (const Error& error) {
    throw refused(scene.path, fmt::format("{}: {}", part.mesh, error.what()));
  }
  place(laid.motion, part.rotation, part.position_m);
  LoadedMotion motion{{std::move(laid.motion), rate_hz, scene.finger.direction}};
  const Vec3 place_mm = 1e3 * laid.place_P;
  const std::string edges = laid.edges == 0 ? ""
                                            : fmt::format(", eased off round {} sharp edge{}", laid.edges,
                                                          laid.edges == 1 ? "" : "s");
  motion.notes.push_back(
      fmt::format("{}: {} at place {} of {}, ({}, {}, {}) mm in its frame, {} mm deep{}; tried {} {}",
                  scene.name, shape_text(rub), rub.place, part.mesh, rounded_text(place_mm.x(), 4),
                  rounded_text(place_mm.y(), 4), rounded_text(place_mm.z(), 4),
                  rounded_text(1e3 * depth_m, 4), edges, laid.tried, laid.tried == 1 ? "point" : "points"));
  return motion;
}

/// At the rate that a scene leaves to the program, and that told; as it is where it leaves none.
LoadedMotion at_chosen_rate(const Scene& scene, LoadedMotion motion) {
  if (!scene.motion.automatic_rate) return motion;
  const RateChoice choice = choose_rate(scene, &motion.path);
  motion.path = motion.path.with_rate(choice.rate_hz);
  motion.notes.push_back(fmt::format("{}: {}", scene.name, choice.reason));
  if (scene.hand) refuse_hand_too_quick(*scene.hand, choice.rate_hz, scene.path);
  return motion;
}

/// It is laid for ticks of its rate: where that is chosen by a motion, anew at that rate.
LoadedMotion laid_at_chosen_rate(const Scene& scene, MeshStore& meshes) {
  const double first_hz = scene.motion.rate_hz;
  LoadedMotion motion = at_chosen_rate(scene, laid_motion(scene, first_hz, meshes));
  const double chosen_hz = motion.path.rate_hz();
  if (chosen_hz == first_hz) return motion;
  LoadedMotion again = laid_motion(scene, chosen_hz, meshes);
  again.notes.push_back(motion.notes.back());  // why that rate
  return again;
}

void warn_of_odd_force(Reading& reading) {
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

/// The residual would be that of a wrong sign.
void warn_of_driving_force(Reading& reading) {
  const Motion& motion = reading.motion;
  if (motion.force_W_n.cols() == 0 || reading.clock.rate_hz == 0) return;
  if (driving_share(motion.p_WQ, motion.force_W_n, reading.clock.rate_hz) > most_driving_share)
    reading.warn(
        "its measured force drives the finger along its way, and friction holds a finger back: is it that on "
        "the surface (force_on = \"plate\")?");
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
    throw refused(scene.name, std::string(why) + " (a mesh by itself has none: name a scene)");
  }
  if (settings.scripted) return at_chosen_rate(scene, scripted_motion(scene));
  if (settings.laid) return laid_at_chosen_rate(scene, meshes);
  Reading reading{scene, settings, {}, {}, {}, {}, {}};
  read_file(reading);
  reading.clock = recording_clock(reading.motion.t_s);
  if (settings.has_own_rate() || is_refined(settings))
    refuse_wild_rate(reading, settings.has_own_rate() ? 1 : 0);
  const double rate_hz = settled_rate_hz(reading);
  if (settings.has_own_rate()) keep_last_sample(reading.motion, reading.clock);
  if (scene.hand && settings.has_own_rate()) refuse_hand_too_quick(*scene.hand, rate_hz, scene.path);
  if (settings.has_own_rate() || is_refined(settings)) warn_of_odd_steps(reading);
  warn_of_odd_force(reading);
  warn_of_driving_force(reading);
  if (is_refined(settings)) refine(reading);
  if (!settings.placement.is_world()) {
    const MotionPose pose = pose_of(scene);
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
