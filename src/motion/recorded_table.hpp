#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/types.hpp"
#include "base/unit_row.hpp"
#include "motion/recording_format.hpp"

namespace fingerpad {

/// What a file calls a column, by its place in recording_columns.
std::string_view header_of(const RecordingFormat& format, std::size_t place);

/// Those names of a header that by their words number trials or subjects: "Trial No", "subject".
std::vector<std::string> trial_names(const std::vector<std::string>& header);

/// Which of recording_columns a recording is asked for.
struct AskedColumns {
  std::vector<std::size_t> places;      ///< in recording_columns; those that must be there come first
  std::vector<std::string_view> names;  ///< likewise, as the file calls them
  std::size_t required = 0;             ///< how many must be there
};
/// Time, place and what the format names must be there; directions and attitudes may be. The names stand in
/// `format`, or nowhere else for ever.
AskedColumns asked_columns(const RecordingFormat& format);

/// A recording as columns of numbers, whatever file they came from, in the units of that file.
struct RecordedTable {
  std::string path;
  std::vector<std::vector<double>> columns;  ///< by the order of recording_columns; empty where absent
  std::vector<long> lines;                   ///< per row: its line in the file; of HDF5 its row, from 1

  /// Of a row, "table.csv:7".
  Error fault(std::size_t row, const std::string& what) const;
  /// How many of the columns first .. last are there.
  int count(std::size_t first, std::size_t last) const;
  /// Three columns as points, 3 x n.
  Points points(std::size_t first) const;
};

/// A table that has the columns asked for. Takes the units that it names into `format`, and keeps the rows of
/// the subject and the trial that the format names.
/// @param columns  per asked.places; empty where absent
/// Throws Error (refused) for units as told_unit_or_ask, for a table without rows, and where no row is left.
RecordedTable recorded_table(const std::string& path, std::vector<std::vector<double>> columns,
                             std::vector<long> lines, const AskedColumns& asked, const UnitRow& units,
                             RecordingFormat& format);

// Where recording_columns has them.
inline constexpr std::size_t place_of_x = 1, place_of_dx = 4, place_of_qw = 7, place_of_fx = 11,
                             place_of_subject = 14, place_of_trial = 15, place_of_fn = 16;
static_assert(recording_columns[place_of_x].key == "x" && recording_columns[place_of_dx].key == "dx" &&
              recording_columns[place_of_qw].key == "qw" && recording_columns[place_of_fx].key == "fx" &&
              recording_columns[place_of_subject].key == "subject" &&
              recording_columns[place_of_trial].key == "trial" && recording_columns[place_of_fn].key == "fn");

}  // namespace fingerpad
