#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "touch/tick_record.hpp"
#include "trace/trace.hpp"

namespace fingerpad {

/// What the numbers of a column are. It says how they are kept (HDF5 and VTP: double; phase in a byte, index
/// in 32 bits), how CSV writes them (a phase by its name), and what is no such number.
enum class ColumnKind {
  number,  ///< any, nan where there is none
  place,   ///< a time or a position: finite
  phase,   ///< 0 free, 1 stick, 2 slip
  index    ///< a whole number from -1
};

/// Which traces have a column. Where one lacks it a record is as it is made.
enum class ColumnOf {
  every_trace,
  hdf5,           ///< HDF5 alone, but for those of older programs
  several_walls,  ///< TraceInfo::several_walls
  hands,          ///< TraceInfo::in_hand
  estimated,      ///< TraceInfo::estimated
  turning,        ///< TraceInfo::turning
  attitudes,      ///< TraceInfo::attitudes
  sent,           ///< TraceInfo::sent
  compared        ///< TraceInfo::compared
};

/// One column of a trace: all that is known of it. Writers, readers, exports and the documentation go by
/// these rows.
struct TraceColumn {
  std::string_view name;  ///< in HDF5, and CSV's header
  std::string_view unit;  ///< "s", "m", "N", "rad", "1" (pure number or name)
  std::string_view doc;   ///< columns that belong together say the same
  ColumnKind kind;
  double (*get)(const TickRecord& record) noexcept;
  /// @param value  read_value has nothing against
  void (*set)(TickRecord& record, double value) noexcept;
  /// The rows' values as HDF5 keeps them, one behind the other: kept_bytes(kind) each.
  void (*gather)(std::span<const TickRecord> rows, std::byte* out) noexcept;
  std::string_view values{};  ///< what its numbers stand for, an attribute in HDF5; empty: what `unit` says
  ColumnOf of = ColumnOf::every_trace;
  bool of_the_way = false;  ///< it says where a motion or a hand put the finger, not what was felt there
};

/// All columns there are, in file order: t_s .. triangle first.
std::span<const TraceColumn> trace_columns() noexcept;
/// Those that a trace of this run is written with, in HDF5 and in CSV.
std::vector<TraceColumn> trace_columns(const TraceInfo& info);
std::vector<TraceColumn> csv_columns(const TraceInfo& info);
/// Tells the info of a trace that it has a column.
void tell_of(const TraceColumn& column, TraceInfo& info) noexcept;

/// The bytes of one value in HDF5: 8 of a double, 4 of an index, 1 of a phase.
std::size_t kept_bytes(ColumnKind kind) noexcept;

/// Puts a number that a file has in this column into a record.
/// @returns  what is wrong with it (a phase that is none, a time or a position that is not finite), and then
///           the record is as it was; empty if nothing
std::string_view read_value(const TraceColumn& column, double value, TickRecord& record) noexcept;

/// The table of columns as the README has it, in Markdown.
std::string trace_columns_text();

}  // namespace fingerpad
