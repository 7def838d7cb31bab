#pragma once

#include <array>
#include <string>
#include <string_view>

#include "motion/field_format.hpp"

namespace fingerpad {

/// A published recording whose description says what was measured, but not how its tables name it: what the
/// user must say is asked for, nothing is guessed.
struct OpenLayout {
  std::string_view format;            ///< the row's name
  double metres_per_unit = 0;         ///< of positions; 0: not published, to be said
  double newton_metres_per_unit = 0;  ///< of torques; 0: likewise
  bool is_planar = false;             ///< positions may lack z, which is 0 then
};

/// Reads such a recording by the columns that `format` names: t, x, y (and z), and of the force fx, fy, fz
/// and fn whatever is named. Torques (tx, ty, tz, beside the forces) are read for a measurement's contact
/// point; a speed (beside the positions, in their unit a second unless its own is told) is held against the
/// positions, which tells a wrong unit. A line of units below a table's header answers what is open of them.
/// Positions with a clock of their own stand in the file `format.positions_path`, with a time column of the
/// same name, and are joined to the forces (join_clocks). `forces_on_surface` turns forces to those on the
/// finger. Throws Error (refused) with the question for whatever is open, for a column that is named beside
/// those, and where most of the normal force is below 0, unless it is in a sensor's axes: that is the load on
/// the surface.
FieldRecording read_open_layout(const std::string& path, const RecordingFormat& format,
                                const OpenLayout& layout);

/// What such a row asks for of the keys that say how a file is read (FieldFormat::keys).
inline constexpr std::array<std::string_view, 8> open_layout_keys{
    "columns", "unit", "time_unit", "force_unit", "separator", "decimal", "positions", "force_on"};

/// The file, and that of its positions where there is one.
std::vector<std::string> open_layout_files(const std::string& path, const RecordingFormat& format);

/// Where recording_columns has a key. @pre it has
std::size_t recording_column_place(std::string_view key) noexcept;

}  // namespace fingerpad
