#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene_change.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

struct World;

/// What a trace says about the run it records, enough to repeat it.
struct TraceInfo {
  std::string scene_name;
  std::string scene_text;  ///< whole scene as TOML
  std::uint64_t seed = 1;
  double rate_hz = 0;
  std::string version;                   ///< of fingerpad
  std::vector<std::string> mesh_files;   ///< as written in the scene, one per part
  std::vector<std::string> mesh_hashes;  ///< file_hash of each
  std::string motion_file;               ///< as written; empty for live touch and scripted motions
  std::string motion_hash;
  // What its rows say that the tick was told, beyond the finger's place:
  bool several_walls = false;  ///< how many walls hold the finger, where several can
  bool in_hand = false;        ///< where a hand's encoders put the finger, and what the hand pushed it with
  bool estimated = false;      ///< the velocity, which is not the positions' difference
  bool turning = false;        ///< the direction of a finger that turns
  bool attitudes = false;      ///< its attitude
  bool sent = false;           ///< what a device with motors was sent of the force
  bool compared = false;       ///< what the force has beyond the one that was measured
  std::vector<std::string>
      motion_notes;                  ///< how it was read and what was made of it (LoadedMotion), a line each
  std::string profile_text;          ///< the profile file's text, empty without one
  std::string contact_method;        ///< that served: a row's name, or "plane" without a part
  std::string contact_normals;       ///< a row's name
  std::vector<SceneChange> changes;  ///< made while it was touched, in order of time
  std::vector<std::string> contact_reasons;  ///< why, where the scene left it open: a line a part
  /// The columns that were asked for, where not all were: names, in file order (trace_choice.hpp).
  std::vector<std::string> columns;
  std::uint64_t every = 1;  ///< rows are every so manieth tick, and the last
  bool deflated = false;    ///< HDF5: its columns, but for time, and its tables are deflated
};

/// A trace read whole.
struct Trace {
  TraceInfo info;  ///< empty texts where the file has none (CSV)
  std::vector<TickRecord> rows;
  bool complete = true;  ///< false: the recording was cut short (its last flush is the end)
  std::string cut = {};  ///< of one that is not complete: how, "ends within a row (line 12)"
  /// The surfaces as embedded in the file, in their order; without trees. Empty for CSV, and where a part was
  /// too large to be embedded: then only its mesh file has its shape.
  std::shared_ptr<const World> world;
  /// Columns that every whole trace has, and this one was written without; rows are there as they are made.
  std::vector<std::string> missing;
  /// All columns that the file does not have, those of other kinds of runs too; rows are there as they are
  /// made.
  std::vector<std::string> absent;
};

/// What of a trace is wanted: the surfaces cost time to rebuild. `some_rows` takes a trace that was written
/// without some of its columns too; the others refuse it, and name what is missing.
enum class TraceContents { all, rows, some_rows };

/// Reads a trace, HDF5 or CSV, by content. Throws Error (refused) for a file that is neither, lacks a column,
/// or whose columns differ in length by more than an unfinished flush explains (then the shortest counts). A
/// CSV named `*.part` is one that was cut short, and so is one whose last row has no line end: that row is
/// passed over, for its last number may lack digits.
///
/// Traces may come from anyone: an HDF5 file is read by a child process (fork), where HDF5 may crash, and one
/// that keeps anything outside of itself (external storage, links, virtual datasets) is refused.
Trace read_trace(const std::string& path);
Trace read_trace(const std::string& path, TraceContents contents);

/// Of a recording that its writer has not finished: whether that is still at work is not told by the file.
inline constexpr std::string_view unfinished_words =
    "is of a recording that was cut short or is still being written";

/// "ends within a row (line 12); read up to t = 0.01 s", behind the trace's name; empty of a complete one.
std::string early_end_words(const Trace& trace);

/// Throws Error (refused) for a trace that has no row, with why where that is known.
void refuse_no_rows(const Trace& trace, const std::string& path);

/// True if the file starts like an HDF5 file.
bool is_hdf5(const std::string& path);

/// Throws Error (refused) for a file whose name ends as an HDF5 file's and whose bytes do not start like
/// one's.
void refuse_false_hdf5(const std::string& path);

/// What the column `every` of a trace as CSV says, one with some columns alone too; 1 where it has none, and
/// for all other files.
std::uint64_t every_of_csv(const std::string& path);

/// True if it is a file of text whose first line names columns of a trace alone, t_s first, though not all.
bool is_partial_csv_trace(const std::string& path);

/// True if it is a file of text whose first line tells that this program wrote it as a trace, whole or of
/// some columns: one of these is none that a recording of another's may have.
bool is_own_csv_trace(const std::string& path);
/// Throws Error (refused) where a header that stands below other lines of a file is one of such a trace: what
/// is known of a trace by its first line would be missed.
void refuse_trace_below(const std::string& path, const std::vector<std::string>& header);

/// True if it is a file of text whose first line names all columns of a trace. False for a stream, which can
/// be read once.
bool is_csv_trace(const std::string& path);

}  // namespace fingerpad
