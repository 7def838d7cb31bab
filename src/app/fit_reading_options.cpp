#include "app/fit_reading_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/output_name.hpp"
#include "app/quantity_option.hpp"
#include "app/word_option.hpp"
#include "base/error.hpp"
#include "base/unit.hpp"
#include "motion/field_format.hpp"
#include "study/measurement_reader.hpp"

namespace fingerpad {
namespace {

struct NamedMark {
  std::string_view name;
  char mark;
};
constexpr NamedMark separators[] = {
    {"comma", ','}, {"semicolon", ';'}, {"tab", '\t'}, {"bar", '|'}, {"blank", ' '}};

template <typename Table>
std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  names.reserve(std::size(table));
  for (const auto& row : table) names.emplace_back(row.name);
  return names;
}

const std::string lengths = "mm, cm, m, in";

/// The mark's name, of one that was given itself, as --separator ';'.
std::string name_of_mark(const std::string& text) {
  if (text == "\\t") return "tab";
  for (const NamedMark& row : separators)
    if (text.size() == 1 && text.front() == row.mark) return std::string(row.name);
  return text;
}

/// @pre the command line has checked that it is there
char mark_of(const std::string& name) {
  const auto is_it = [&](const NamedMark& row) { return row.name == name; };
  return std::find_if(std::begin(separators), std::end(separators), is_it)->mark;
}

Error fit_usage(const std::string& option, const std::string& what) {
  return {ErrorKind::usage, option, what};
}

void take_columns(const std::vector<std::string>& columns, MeasurementFormat& format) {
  for (const std::string& said : columns) {
    const std::size_t equals = said.find('=');
    const std::string key = said.substr(0, equals);
    const auto is_it = [&](const RecordingColumn& column) { return column.key == key; };
    const auto found = std::find_if(measurement_columns.begin(), measurement_columns.end(), is_it);
    if (equals == std::string::npos || equals + 1 == said.size() || found == measurement_columns.end()) {
      std::string keys;
      for (const RecordingColumn& column : measurement_columns) keys += fmt::format(" {}", column.key);
      throw fit_usage("--columns", fmt::format("'{}' is no KEY=NAME with a KEY of:{}", said, keys));
    }
    format.headers[static_cast<std::size_t>(found - measurement_columns.begin())] = said.substr(equals + 1);
  }
  for (std::size_t i = 0; i < format.headers.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!format.headers[i].empty() && format.headers[i] == format.headers[k])
        throw fit_usage("--columns",
                        fmt::format("'{}' and '{}' are both the column '{}'", measurement_columns[k].key,
                                    measurement_columns[i].key, format.headers[i]));
    }
  }
}

std::optional<SixAxisSensor> sensor_of(const ReadingOptions& options) {
  if (options.sensor_at.empty() && options.sensor_turned.empty()) return std::nullopt;
  SixAxisSensor sensor;
  if (!options.sensor_at.empty()) sensor.origin_W = Vec3(options.sensor_at.data());
  if (!options.sensor_turned.empty()) {
    const std::vector<double>& q = options.sensor_turned;
    const Eigen::Quaterniond turn(q[0], q[1], q[2], q[3]);
    if (!(std::abs(turn.norm() - 1) < 1e-3))
      throw fit_usage("--sensor-turned",
                      fmt::format("its length is {}, that of a unit quaternion is 1", turn.norm()));
    sensor.rotation_WS = turn.normalized().toRotationMatrix();
  }
  sensor.plate_height_m = options.plate_height_m.value_or(0);
  sensor.says_place = !options.sensor_at.empty();
  return sensor;
}

/// Torque tells the contact point of a six-axis sensor, and nothing else.
void refuse_unread_torque(const ReadingOptions& options) {
  const FieldFormat* layout = find_field_format(options.reader);
  const bool names_torque =
      std::any_of(options.columns.begin(), options.columns.end(), [](const std::string& said) {
        return said.starts_with("tx=") || said.starts_with("ty=") || said.starts_with("tz=");
      });
  if (layout != nullptr && layout->takes_torque && !options.torque_unit.empty() && !names_torque)
    throw fit_usage("--torque-unit", "no torque is named: name tx, ty and tz in --columns, or leave it out");
  if (!options.sensor_at.empty() || !options.sensor_turned.empty()) return;
  if (layout != nullptr && layout->takes_torque && !options.plate_height_m) return;
  const char* unread = !options.torque_unit.empty() ? "--torque-unit"
                       : options.plate_height_m     ? "--plate-height"
                                                    : nullptr;
  if (unread != nullptr)
    throw fit_usage(unread, "is read with --sensor-at (or --sensor-turned) alone, of a six-axis sensor");
}

void add_units(CLI::App& command, ReadingOptions& options) {
  command.add_option("--unit", options.unit, "Of positions")
      ->check(one_of(length_unit_names()))
      ->default_str("m, or the layout's own");
  command.add_option("--time-unit", options.time_unit, "Of times")
      ->transform([](const std::string& said) { return std::string(listed_unit(Quantity::time, said)); }, "")
      ->check(one_of(names_of(time_units)))
      ->default_str("s, or the layout's own");
  command.add_option("--force-unit", options.force_unit, "Of forces")
      ->check(one_of(names_of(force_units)))
      ->default_str("N");
  command.add_option("--torque-unit", options.torque_unit, "Of torques")
      ->check(one_of(names_of(torque_units)))
      ->default_str("N.m, or the layout's own");
  command
      .add_option("--separator", options.separator,
                  "Between cells, by name or as the mark itself; found where it is left out")
      ->transform(name_of_mark)
      ->check(one_of(names_of(separators)));
  command.add_option("--decimal", options.decimal, "Mark of numbers")
      ->check(one_of({".", ","}))
      ->capture_default_str();
}

}  // namespace

void add_reading_options(CLI::App& command, ReadingOptions& options) {
  std::vector<std::string> readers;
  for (const MeasurementReader& reader : measurement_readers()) readers.emplace_back(reader.name);
  command
      .add_option("--reader", options.reader,
                  "Layout of the files; told by their contents where it is left out")
      ->check(one_of(readers));
  command
      .add_option(
          "--columns", options.columns,
          "Columns that are called otherwise: t x y z, fx fy fz (force), nx ny nz (plate's "
          "normal), dx dy dz (finger), m1x.. m2z (markers), tx ty tz (torque), subject, trial; speed where a "
          "--reader takes it")
      ->type_name("KEY=NAME,")
      ->delimiter(',');
  add_units(command, options);
  command
      .add_option(
          "--trial-unit", options.trial_units,
          "Forces (mN) or positions (mm) of a trial are in another unit than its file's; again for each")
      ->type_name("NAME=UNIT")
      ->allow_extra_args(false);
  command
      .add_option("--leave-out", options.left_out,
                  "A trial to leave out, as messages name it ('subject 1, trial 3', FILE before it), or "
                  "'trial 3' of all; again for each")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command.add_option("--force-on", options.force_on, "What the recorded forces act on")
      ->check(one_of({"finger", "plate"}))
      ->capture_default_str();
  take_units(
      command.add_option("--markers", options.markers,
                         "Positions are of two markers, proximal (m1x..) and distal (m2x..); the fingertip "
                         "is so far beyond the distal one, along their line, and so far below [m]"),
      factors_of(Quantity::length), lengths)
      ->delimiter(',')
      ->type_name("BEYOND,BELOW")
      ->expected(2);
  take_units(
      command.add_option(
          "--sensor-at", options.sensor_at,
          "Where a six-axis sensor's axes are [m]: with torque the contact point is told from the wrench"),
      factors_of(Quantity::length), lengths)
      ->delimiter(',')
      ->type_name("X,Y,Z")
      ->expected(3);
  refuse_empty(
      command.add_option("--positions", options.positions,
                         "A table of positions with a clock of their own, where a --reader has them so"));
  command
      .add_option("--sensor-turned", options.sensor_turned,
                  "The quaternion that turns the sensor's axes to those of positions")
      ->delimiter(',')
      ->type_name("W,X,Y,Z")
      ->expected(4);
  take_units(command.add_option("--plate-height", options.plate_height_m,
                                "Of the plate along its normal, with --sensor-at [m]"),
             factors_of(Quantity::length), lengths)
      ->default_str("0");
}

MeasurementFormat measurement_format(const ReadingOptions& options) {
  MeasurementFormat format;
  take_columns(options.columns, format);
  format.says_unit = !options.unit.empty();
  format.says_time_unit = !options.time_unit.empty();
  if (format.says_unit) format.metres_per_unit = *si_per_unit(Quantity::length, options.unit);
  if (format.says_time_unit) format.seconds_per_unit = *si_per_unit(Quantity::time, options.time_unit);
  if (!options.positions.empty() && !asks_for_key(options.reader, "positions"))
    throw fit_usage("--positions",
                    fmt::format("is read with a --reader that has positions in a file of their own{}",
                                options.reader.empty() ? "" : ", which '" + options.reader + "' has not"));
  format.positions_path = options.positions;
  format.says_force_unit = !options.force_unit.empty();
  if (format.says_force_unit) format.newtons_per_unit = *si_per_unit(Quantity::force, options.force_unit);
  if (!options.trial_units.empty() && find_field_format(options.reader) != nullptr)
    throw fit_usage("--trial-unit",
                    fmt::format("is not read with --reader {}, whose units are the layout's own: leave the "
                                "trial out (--leave-out)",
                                options.reader));
  refuse_unread_torque(options);
  format.says_torque_unit = !options.torque_unit.empty();
  if (format.says_torque_unit)
    format.newton_metres_per_unit = *si_per_unit(Quantity::torque, options.torque_unit);
  if (!options.separator.empty()) format.dialect.separator = mark_of(options.separator);
  format.dialect.decimal = options.decimal.front();
  format.force_on_plate = options.force_on == "plate";
  if (!options.markers.empty()) format.markers = TwoMarkers{options.markers[0], options.markers[1]};
  format.sensor = sensor_of(options);
  return format;
}

}  // namespace fingerpad
