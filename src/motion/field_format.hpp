#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/unit_row.hpp"
#include "motion/motion.hpp"
#include "motion/recording_format.hpp"

namespace fingerpad {

/// A recording as a laboratory or a database saved it, in the program's units and on one clock.
struct FieldRecording {
  Motion motion;
  std::vector<std::string> notes;     ///< how it was read, a line each, for people
  std::vector<std::string> warnings;  ///< what in it is not as it should be
  RecordingFormat read_as;  ///< with what a table of the program's own kind says itself: separator, units
  ToldUnits told_units;     ///< by lines below its tables' headers
  Points torque_W_n_m;      ///< 3 x n, on the finger, about the sensor's origin, or 3 x 0 [N m]
};

/// A published layout of recordings: one row of a table, one file.
struct FieldFormat {
  std::string_view name;          ///< `format = "..."` and `--format`
  std::string_view summary;       ///< what it is, for people
  std::string_view touched_with;  ///< "a bare finger"; a profile is a finger pad's only then
  bool is_bare_finger = false;
  /// All files that `path` stands for, itself first.
  std::vector<std::string> (*files)(const std::string& path, const RecordingFormat& format);
  /// Throws Error (refused) for what is not as its description says, and, where that leaves something open
  /// that the user's `format` does not say, with the question.
  FieldRecording (*read)(const std::string& path, const RecordingFormat& format);
  /// Of the keys that say how a file is read (columns, unit, time_unit, force_unit, separator, decimal,
  /// positions, force_on, subject, trial) those that `read` asks for; no other is taken.
  std::span<const std::string_view> keys;
  /// Forces and positions are in the same axes: then a fit may take both.
  bool has_one_frame = true;
  bool takes_torque = false;  ///< and speed: RecordingFormat::torque_headers, speed_header
};

/// All named formats, in the order of the documentation.
std::span<const FieldFormat> field_formats() noexcept;
/// The row of a name; nullptr if there is none.
const FieldFormat* find_field_format(std::string_view name) noexcept;

/// Whether a row of this name, or the program's own kind of table where there is none, asks for a key.
bool asks_for_key(std::string_view name, std::string_view key) noexcept;
/// Throws Error (refused) for what `format` says that its row does not ask for, by its key.
void refuse_unasked_keys(const std::string& path, const RecordingFormat& format);

/// Reads a recording as its format says: by the named row, or as a table of the program's own kind. Throws
/// Error (refused) as that and refuse_unasked_keys.
FieldRecording read_field_recording(const std::string& path, const RecordingFormat& format);
/// The files that are read then.
std::vector<std::string> field_files(const std::string& path, const RecordingFormat& format);

/// The table of formats as the README has it, in Markdown.
std::string field_formats_text();

}  // namespace fingerpad
