#include "app/measurement_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/output_name.hpp"
#include "base/error.hpp"
#include "base/unit.hpp"
#include "study/measurement_reader.hpp"

namespace fingerpad {
namespace {

std::vector<std::string> reader_names() {
  std::vector<std::string> names;
  for (const MeasurementReader& row : measurement_readers()) names.emplace_back(row.name);
  return names;
}

std::vector<std::string> time_unit_names() {
  std::vector<std::string> names;
  for (const TimeUnit& unit : time_units) names.emplace_back(unit.name);
  return names;
}

std::string known_keys() {
  std::string keys;
  for (const RecordingColumn& column : measurement_columns)
    keys += fmt::format("{}{}", keys.empty() ? "" : ", ", column.key);
  return keys;
}

void take_column(const std::string& said, MeasurementFormat& format) {
  const std::size_t equals = said.find('=');
  const auto usage = [&](const std::string& why) {
    return Error(ErrorKind::usage, "--columns", fmt::format("'{}' {}", said, why));
  };
  if (equals == std::string::npos || equals + 1 == said.size())
    throw usage("says no column: write KEY=NAME, as in t=time,x=\"pos x\"");
  const std::string key = said.substr(0, equals);
  const auto found = std::find_if(measurement_columns.begin(), measurement_columns.end(),
                                  [&](const RecordingColumn& column) { return column.key == key; });
  if (found == measurement_columns.end())
    throw usage(fmt::format("names a quantity that is not known; known are {}", known_keys()));
  format.headers[static_cast<std::size_t>(found - measurement_columns.begin())] = said.substr(equals + 1);
}

char separator_mark(const std::string& word) {
  if (word == "auto") return found_separator;
  if (word == "tab") return '\t';
  return word == "space" ? ' ' : word.front();
}

}  // namespace

void add_measurement_options(CLI::App& command, MeasurementOptions& options) {
  command
      .add_option("--reader", options.reader,
                  "How the files are laid out: hdf5, table, or a layout that others publish")
      ->check(CLI::IsMember(reader_names()))
      ->default_str("as each file is recognised");
  command
      .add_option("--columns", options.columns,
                  "What columns are called, as KEY=NAME parted by commas; keys: " + known_keys())
      ->delimiter(',')
      ->default_str("t=t_s,x=x_m,...");
  command.add_option("--unit", options.unit, "Of positions")
      ->check(CLI::IsMember(length_unit_names()))
      ->default_str("m, or the layout's own");
  command.add_option("--time-unit", options.time_unit, "Of times")
      ->check(CLI::IsMember(time_unit_names()))
      ->default_str("s, or the layout's own");
  command.add_option("--separator", options.separator, "Between a table's cells")
      ->check(CLI::IsMember({"auto", ",", ";", "tab", "space"}))
      ->capture_default_str();
  command.add_option("--decimal", options.decimal, "Mark within a table's numbers")
      ->check(CLI::IsMember({".", ","}))
      ->capture_default_str();
  command.add_option("--force-on", options.force_on, "What the measured forces act on")
      ->check(CLI::IsMember({"finger", "plate"}))
      ->capture_default_str();
  refuse_empty(
      command.add_option("--positions", options.positions,
                         "A table of positions with a clock of their own, where a layout has them so"));
}

MeasurementFormat measurement_format(const MeasurementOptions& options) {
  MeasurementFormat format;
  for (const std::string& said : options.columns) take_column(said, format);
  format.says_unit = !options.unit.empty();
  if (format.says_unit) format.metres_per_unit = *metres_per_unit(options.unit);
  for (const TimeUnit& unit : time_units) {
    if (unit.name != options.time_unit) continue;
    format.seconds_per_unit = unit.seconds;
    format.says_time_unit = true;
  }
  format.dialect = {separator_mark(options.separator), options.decimal.front()};
  format.positions_path = options.positions;
  format.force_on_plate = options.force_on == "plate";
  return format;
}

}  // namespace fingerpad
