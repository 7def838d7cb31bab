#include "study/measurement_field.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "study/measured_row.hpp"
#include "study/six_axis_sensor.hpp"
#include "study/trial_rows.hpp"

namespace fingerpad {
namespace {

/// What a measurement's format says, as a recording's.
RecordingFormat recording_format(const FieldFormat& layout, const MeasurementFormat& format) {
  RecordingFormat said;
  said.name = layout.name;
  for (std::size_t k = 0; k < recording_columns.size(); ++k) {
    for (std::size_t m = 0; m < measurement_columns.size(); ++m)
      if (measurement_columns[m].key == recording_columns[k].key) said.headers[k] = format.headers[m];
  }
  said.metres_per_unit = format.metres_per_unit;
  said.seconds_per_unit = format.seconds_per_unit;
  said.newtons_per_unit = format.newtons_per_unit;
  said.dialect = format.dialect;
  said.positions_path = format.positions_path;
  said.says_unit = format.says_unit;
  said.says_time_unit = format.says_time_unit;
  said.takes_torque = true;
  said.says_force_unit = format.says_force_unit;
  said.forces_on_surface = format.force_on_plate;
  said.is_sensor_turned = format.sensor.has_value();
  for (std::size_t axis = 0; axis < 3; ++axis)
    said.torque_headers[axis] = format.headers[static_cast<std::size_t>(MeasuredColumn::torque) + axis];
  said.speed_header = format.headers[static_cast<std::size_t>(MeasuredColumn::speed)];
  said.newton_metres_per_unit = format.newton_metres_per_unit;
  said.says_torque_unit = format.says_torque_unit;
  return said;
}

/// What only tables of the program's own kind are read with.
void refuse_unread(const FieldFormat& layout, const std::string& path, const MeasurementFormat& format) {
  const auto refuse = [&](std::string_view option) {
    return refused(path, fmt::format("{} is not read with --reader {}: leave it out", option, layout.name));
  };
  const auto is_wrench = [&](std::size_t m) {
    const auto first = static_cast<std::size_t>(MeasuredColumn::torque);
    return layout.takes_torque &&
           ((m >= first && m < first + 3) || m == static_cast<std::size_t>(MeasuredColumn::speed));
  };
  for (std::size_t m = 0; m < measurement_columns.size(); ++m) {
    if (is_wrench(m)) continue;
    const auto is_it = [&](const RecordingColumn& column) {
      return column.key == measurement_columns[m].key;
    };
    if (!format.headers[m].empty() && std::none_of(recording_columns.begin(), recording_columns.end(), is_it))
      throw refuse(fmt::format("the column {} of --columns", measurement_columns[m].key));
  }
  if (format.markers) throw refuse("--markers");
  const bool has_torque = !format.headers[static_cast<std::size_t>(MeasuredColumn::torque)].empty();
  if (format.sensor && !layout.takes_torque) throw refuse("--sensor-at (or --sensor-turned)");
  if (format.sensor && !has_torque)
    throw refused(path,
                  "--sensor-at says how a six-axis sensor stands, and no torque is named: name tx, ty and tz "
                  "in --columns, or leave it out");
}

}  // namespace

void read_measured_field(const FieldFormat& layout, const std::string& path, const MeasurementFormat& format,
                         RecordedMeasurement& into) {
  refuse_unread(layout, path, format);
  const RecordingFormat said = recording_format(layout, format);
  refuse_unasked_keys(path, said);
  const FieldRecording recording = layout.read(path, said);
  for (const std::string& note : recording.notes) into.notes.push_back(fmt::format("{}: {}", path, note));
  for (const std::string& warning : recording.warnings)
    into.warnings.push_back(fmt::format("{}: {}", path, warning));
  into.told_units[path] = recording.told_units;
  const Motion& motion = recording.motion;
  if (motion.force_W_n.cols() == 0) {
    into.without_force.push_back(fmt::format(
        "{}: column fx_n missing{}", path,
        motion.normal_force_n.empty()
            ? ""
            : fmt::format(
                  ": {} has the normal force alone here{}", layout.name,
                  motion.p_WQ.row(2).isZero(0) ? ", and no height that would tell a normal law" : "")));
    return;
  }
  if (!layout.has_one_frame) {
    into.without_force.push_back(
        fmt::format("{}: {} has forces in the surface's axes and positions in others, and does not say how "
                    "these stand to "
                    "each other, which a fit must know",
                    path, layout.name));
    return;
  }
  if (!layout.is_bare_finger)
    into.warnings.push_back(
        fmt::format("{}: was touched with {}: the numbers of the fit are of that, not of a finger pad", path,
                    layout.touched_with));
  TrialRows trial(path, 0, static_cast<int>(into.trials.size()) + 1, false);
  for (Eigen::Index i = 0; i < motion.p_WQ.cols(); ++i) {
    RecordedRow row;
    row.t_s = motion.t_s[static_cast<std::size_t>(i)];
    row.position_W = motion.p_WQ.col(i);
    row.force_W = motion.force_W_n.col(i);
    if (format.sensor) {
      const Vec3 torque_S_n_m = recording.torque_W_n_m.col(i);
      take_wrench(*format.sensor, format.sensor->says_place ? &torque_S_n_m : nullptr, row);
    }
    trial.add(row);
  }
  trial.finish(into);
}

}  // namespace fingerpad
