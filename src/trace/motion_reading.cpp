#include "trace/motion_reading.hpp"

#include <filesystem>

#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "base/unit.hpp"
#include "motion/field_format.hpp"
#include "part/mesh_format.hpp"
#include "part/text_cursor.hpp"
#include "trace/hdf5_motion.hpp"
#include "trace/motion_doubts.hpp"
#include "trace/motion_of_trace.hpp"
#include "trace/trace.hpp"

namespace fingerpad {
namespace {

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

void warn_of_thinned(MotionReading& reading, std::uint64_t every) {
  if (every <= 1) return;
  reading.warn(fmt::format(
      "is a trace with 1 row in {} ticks (replay --every): between its rows the finger goes straight, so "
      "this is not the motion of its run, nor will the forces be; replay its scene without --every",
      every));
}

/// A scene or a mesh that is named as a motion is told as what it is, rather than read as a table.
void refuse_by_ending(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  const bool is_toml = same_word(ending, ".toml");
  if (!is_toml && format_of_ending(ending) == nullptr) return;
  throw refused(path,
                fmt::format("is by its name {}, and no motion: [motion] file takes a table with t_s, x_m, "
                            "y_m and z_m or a trace",
                            is_toml ? "a scene or a profile" : "a mesh"));
}

FieldRecording read_table_of_hdf5(const MotionSettings& settings) {
  FieldRecording recording;
  recording.read_as = settings.format;
  recording.motion = read_motion_hdf5(settings.file_path, recording.read_as);
  recording.read_as.dialect.separator = ',';  // which parts no cells
  return recording;
}

FieldRecording read_table_of_text(MotionReading& reading) {
  const std::string& path = reading.settings.file_path;
  RecordingFormat format = reading.settings.format;
  format.ends_each_row = is_own_csv_trace(path);
  FieldRecording recording = read_field_recording(path, format);
  reading.says_time_unit = format.ends_each_row || !format.name.empty();
  reading.says_force_unit = format.ends_each_row || !asks_for_key(format.name, "force_unit") ||
                            recording.told_units[static_cast<std::size_t>(Quantity::force)].has_value();
  if (!recording.read_as.cut.empty()) reading.warn(recording.read_as.cut);
  if (!recording.read_as.above.empty()) {
    refuse_trace_below(path, recording.read_as.names);
    reading.note(recording.read_as.above);
  }
  warn_of_thinned(reading, every_of_csv(path));
  return recording;
}

/// What the program has written itself says all of itself.
void read_own_trace(MotionReading& reading) {
  const MotionSettings& settings = reading.settings;
  if (!settings.table_key.empty()) {
    throw refused(reading.scene.path,
                  fmt::format("'{}' in [motion] says how a table is to be read, and {} is a trace of this "
                              "program (HDF5), which says itself what it holds: leave the key out",
                              settings.table_key, settings.file));
  }
  reading.says_time_unit = reading.says_force_unit = true;
  Trace trace = read_trace(settings.file_path, TraceContents::rows);
  reading.motion = motion_of_trace(trace, settings.file_path, settings.format.reads_normal_force);
  warn_of_thinned(reading, trace.info.every);
  if (const std::string words = early_end_words(trace); !words.empty()) reading.warn(words);
  reading.changes = std::move(trace.info.changes);
  if (!reading.changes.empty())
    reading.note(fmt::format("with the {} changes of the scene that were made while it was touched",
                             reading.changes.size()));
}

}  // namespace

void read_file(MotionReading& reading) {
  const MotionSettings& settings = reading.settings;
  const bool reads_force = settings.format.reads_normal_force;
  refuse_by_ending(settings.file_path);
  refuse_false_hdf5(settings.file_path);
  const bool hdf5 = is_hdf5(settings.file_path), hdf5_table = hdf5 && is_hdf5_table(settings.file_path);
  if (!hdf5_table && (hdf5 || (settings.table_key.empty() && is_csv_trace(settings.file_path)))) {
    read_own_trace(reading);
    return;
  }
  FieldRecording recording = hdf5_table ? read_table_of_hdf5(settings) : read_table_of_text(reading);
  reading.says_time_unit = reading.says_time_unit || recording.read_as.says_time_unit;
  reading.says_force_unit = reading.says_force_unit || recording.read_as.says_force_unit;
  reading.motion = std::move(recording.motion);
  if (!reads_force) reading.motion.normal_force_n.clear();
  if (reads_force && reading.motion.normal_force_n.empty())
    throw refused(settings.file_path,
                  "holds no normal force, which normal_force = \"measured\" asks for: where its column is "
                  "called otherwise than fn_n, say columns = { fn = \"NAME\" } in [motion]");
  note_unread_attitude(reading, recording.read_as.names);
  note_unread_trials(reading, recording.read_as.names);
  const std::string how = reading_text(recording.read_as);
  if (!how.empty()) reading.note(how);
  for (const std::string& note : recording.notes) reading.note(note);
  for (const std::string& warning : recording.warnings) reading.warn(warning);
}

bool is_refined(const MotionSettings& settings) {
  return settings.encoder_m > 0 || settings.smoothing_hz > 0;
}

void refine(MotionReading& reading) {
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

}  // namespace fingerpad
