#include "motion/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/unit_row.hpp"
#include "motion/farthest.hpp"
#include "motion/pressed_force.hpp"

namespace fingerpad {
namespace {

/// Beyond the clocks that count from 1970, within what a double still resolves to microseconds.
constexpr double latest_s = 1e10;

/// A table with its columns in the order of recording_columns; those that are not there are empty.
struct Recording {
  const std::string& path;
  std::vector<std::vector<double>> columns;
  std::vector<long> lines;

  Error fault(std::size_t row, const std::string& what) const {
    return refused(fmt::format("{}:{}", path, lines[row]), what);
  }
  int count(std::size_t first, std::size_t last) const {
    int there = 0;
    for (std::size_t k = first; k <= last; ++k) there += columns[k].empty() ? 0 : 1;
    return there;
  }
  /// Three columns as points.
  Points points(std::size_t first) const {
    Points p(3, static_cast<Eigen::Index>(columns[first].size()));
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<double>& row = columns[first + static_cast<std::size_t>(axis)];
      p.row(axis) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), static_cast<Eigen::Index>(row.size()));
    }
    return p;
  }
};

// Where recording_columns has them.
constexpr std::size_t place_of_x = 1, place_of_dx = 4, place_of_qw = 7, place_of_fx = 11,
                      place_of_subject = 14, place_of_trial = 15, place_of_fn = 16;
static_assert(recording_columns[place_of_x].key == "x" && recording_columns[place_of_dx].key == "dx" &&
              recording_columns[place_of_qw].key == "qw" && recording_columns[place_of_fx].key == "fx" &&
              recording_columns[place_of_subject].key == "subject" &&
              recording_columns[place_of_trial].key == "trial" && recording_columns[place_of_fn].key == "fn");

std::string_view header_of(const RecordingFormat& format, std::size_t column) {
  const std::string& named = format.headers[column];
  return named.empty() ? recording_columns[column].header : std::string_view(named);
}

/// Time, place and what the format names must be there; directions and attitudes may be.
bool is_required(const RecordingFormat& format, std::size_t column) {
  if (!format.headers[column].empty() || column < place_of_dx) return true;
  if (column == place_of_fn) return format.reads_normal_force;
  if (column == place_of_subject) return format.subject.has_value();
  return column == place_of_trial && format.trial.has_value();
}

/// The rows of one subject and one trial, where those are asked for.
void keep_one_trial(const RecordingFormat& format, Recording& recording) {
  if (!format.subject && !format.trial) return;
  const auto is_of = [&recording](std::size_t place, const std::optional<int>& wanted, std::size_t row) {
    return !wanted || recording.columns[place][row] == *wanted;
  };
  std::size_t kept = 0;
  for (std::size_t row = 0; row < recording.lines.size(); ++row) {
    if (!is_of(place_of_subject, format.subject, row) || !is_of(place_of_trial, format.trial, row)) continue;
    for (std::vector<double>& column : recording.columns)
      if (!column.empty()) column[kept] = column[row];
    recording.lines[kept++] = recording.lines[row];
  }
  for (std::vector<double>& column : recording.columns)
    if (!column.empty()) column.resize(kept);
  recording.lines.resize(kept);
  if (kept > 0) return;
  throw refused(recording.path, fmt::format("has no row of{}{}",
                                            format.subject ? fmt::format(" subject {}", *format.subject) : "",
                                            format.trial ? fmt::format(" trial {}", *format.trial) : ""));
}

/// Takes the units that a line below the header names.
/// @param asked  the columns of the request, in its order
void take_units(const CsvRequest& request, const UnitRow& row, const std::vector<std::size_t>& asked,
                RecordingFormat& format) {
  if (row.words.empty()) return;
  std::vector<std::string_view> names = request.required;
  names.insert(names.end(), request.optional.begin(), request.optional.end());
  const auto unit = [&](Quantity quantity, std::initializer_list<std::size_t> columns, bool is_said,
                        double si_per_unit, const char* option) {
    UnitGroup group{quantity, {}, is_said, si_per_unit, option};
    for (std::size_t k = 0; k < asked.size(); ++k)
      if (std::find(columns.begin(), columns.end(), asked[k]) != columns.end()) group.columns.push_back(k);
    return unit_of_group(row, names, group);
  };
  format.seconds_per_unit =
      unit(Quantity::time, {0}, format.says_time_unit, format.seconds_per_unit, "time_unit in [motion]");
  format.says_time_unit = format.says_time_unit || !row.words[0].empty();
  format.metres_per_unit = unit(Quantity::length, {place_of_x, place_of_x + 1, place_of_x + 2},
                                format.says_unit, format.metres_per_unit, "unit in [motion]");
  format.newtons_per_unit =
      unit(Quantity::force, {place_of_fx, place_of_fx + 1, place_of_fx + 2, place_of_fn}, false,
           format.newtons_per_unit, "");
}

Recording read_table(const std::string& path, RecordingFormat& format) {
  CsvRequest request{{},
                     {},
                     format.dialect,
                     TableSource::file,
                     "say which of them stands for what, as in [motion] columns = { t = \"time\" }"};
  request.takes_units = true;
  request.mark_mend = separator_mend;
  request.decimal_key = "decimal = \"{}\" in [motion]";
  request.leaves_out_cut_row = format.ends_each_row;
  std::vector<std::size_t> required, optional;
  for (std::size_t k = 0; k < recording_columns.size(); ++k) {
    if (is_required(format, k)) {
      required.push_back(k);
      request.required.push_back(header_of(format, k));
    } else if (k < place_of_fx) {
      optional.push_back(k);
      request.optional.push_back(header_of(format, k));
    }
  }
  CsvColumns table = read_csv_columns(path, request);
  format.dialect.separator = table.separator;
  format.cut = table.cut;
  required.insert(required.end(), optional.begin(), optional.end());
  take_units(request, table.units, required, format);
  Recording recording{path, std::vector<std::vector<double>>(recording_columns.size()), table.lines};
  if (table.lines.empty()) throw refused(path, "has a header but no rows");
  for (std::size_t i = 0; i < required.size(); ++i)
    recording.columns[required[i]] = std::move(table.columns[i]);
  keep_one_trial(format, recording);
  return recording;
}

void check_times(const Recording& recording, const RecordingFormat& format, const std::vector<double>& t_s) {
  for (std::size_t i = 1; i < t_s.size(); ++i) {
    if (t_s[i] > t_s[i - 1]) continue;
    const char* mend =
        format.trial && format.subject ? ""
        : format.trial ? "; where subjects have trials of the same number, say 'subject' in [motion] too"
                       : "; of a table of several trials say which one: 'trial' in [motion] (and 'subject')";
    throw recording.fault(i, fmt::format("time {} s does not come after {} s{}", t_s[i], t_s[i - 1], mend));
  }
}

void check_samples(const Recording& recording, const Motion& motion) {
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const std::string fault = sample_fault(motion.t_s[i], motion.p_WQ.col(static_cast<Eigen::Index>(i)));
    if (!fault.empty()) throw recording.fault(i, fault);
  }
}

void read_directions(const Recording& recording, Motion& motion) {
  const int columns = recording.count(place_of_dx, place_of_dx + 2);
  if (columns == 0) return;
  if (columns != 3) throw refused(recording.path + ":1", "the finger's direction needs all of dx, dy and dz");
  motion.direction_W = recording.points(place_of_dx);
  for (Eigen::Index i = 0; i < motion.p_WQ.cols(); ++i) {
    const double length = motion.direction_W.col(i).stableNorm();
    if (!(length > 1e-6) || !std::isfinite(length))
      throw recording.fault(static_cast<std::size_t>(i), "dx,dy,dz name no direction");
    motion.direction_W.col(i) /= length;
  }
}

/// Unit to within what a recording's few digits leave.
constexpr double unit_tolerance = 1e-3;

void read_attitudes(const Recording& recording, Motion& motion) {
  const int columns = recording.count(place_of_qw, place_of_qw + 3);
  if (columns == 0) return;
  if (columns != 4)
    throw refused(recording.path + ":1", "the finger's orientation needs all of qw, qx, qy and qz");
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    Eigen::Vector4d q;
    for (std::size_t k = 0; k < 4; ++k)
      q[static_cast<Eigen::Index>(k)] = recording.columns[place_of_qw + k][i];
    const double length = q.stableNorm();
    if (!(std::abs(length - 1) <= unit_tolerance)) {
      throw recording.fault(i, fmt::format("qw,qx,qy,qz is no unit quaternion: its length is {}", length));
    }
    motion.attitude.emplace_back(q[0] / length, q[1] / length, q[2] / length, q[3] / length);
  }
}

void read_normal_forces(const Recording& recording, const RecordingFormat& format, Motion& motion) {
  motion.normal_force_n = recording.columns[place_of_fn];
  for (double& force_n : motion.normal_force_n) force_n *= format.newtons_per_unit;
  if (format.forces_on_surface) turn_to_finger(motion.normal_force_n);
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const std::string fault = force_fault(motion.normal_force_n[i]);
    if (!fault.empty()) throw recording.fault(i, fault);
  }
}

void read_forces(const Recording& recording, const RecordingFormat& format, Motion& motion) {
  const int columns = recording.count(place_of_fx, place_of_fx + 2);
  if (columns == 0) return;
  if (columns != 3)
    throw refused(recording.path + ":1",
                  "a measured force needs all of fx, fy and fz among the columns named");
  motion.force_W_n =
      (format.forces_on_surface ? -1 : 1) * format.newtons_per_unit * recording.points(place_of_fx);
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const std::string fault =
        force_fault(motion.force_W_n.col(static_cast<Eigen::Index>(i)).cwiseAbs().maxCoeff());
    if (!fault.empty()) throw recording.fault(i, fault);
  }
}

}  // namespace

std::string sample_fault(double t_s, const Vec3& p_W) {
  if (!(std::abs(t_s) <= latest_s))
    return fmt::format("time {} s is beyond {} s (is it in another unit than seconds?)", t_s, latest_s);
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(p_W[i]) <= farthest_m))
      return fmt::format(
          "{}_m is {} m; a finger is at most {} m from the origin (is it in another unit than metres?)",
          "xyz"[i], p_W[i], farthest_m);
  }
  return {};
}

std::string force_fault(double normal_force_n) {
  constexpr double hardest_n = 1e6;  // beyond any finger and any press
  if (std::abs(normal_force_n) <= hardest_n) return {};
  return fmt::format("the normal force is {} N; at most {} N are taken", normal_force_n, hardest_n);
}

void refuse_side_of_no_force(const std::string& path, const RecordingFormat& format) {
  if (!format.forces_on_surface || format.reads_normal_force) return;
  for (const std::size_t k : {place_of_fx, place_of_fx + 1, place_of_fx + 2, place_of_fn})
    if (!format.headers[k].empty()) return;
  throw refused(
      path,
      "force_on = \"plate\" says what a measured force acts on, and none is read of it: name fx, fy and "
      "fz, or fn, in columns, or leave force_on out");
}

Motion read_motion_csv(const std::string& path, RecordingFormat& format) {
  refuse_side_of_no_force(path, format);
  const Recording recording = read_table(path, format);
  Motion motion;
  motion.t_s = recording.columns[0];
  for (double& t_s : motion.t_s) t_s *= format.seconds_per_unit;
  check_times(recording, format, motion.t_s);
  motion.p_WQ = format.metres_per_unit * recording.points(place_of_x);
  check_samples(recording, motion);
  read_directions(recording, motion);
  read_attitudes(recording, motion);
  if (format.reads_normal_force) read_normal_forces(recording, format, motion);
  read_forces(recording, format, motion);
  return motion;
}

Motion read_motion_csv(const std::string& path) {
  RecordingFormat format;
  return read_motion_csv(path, format);
}

}  // namespace fingerpad
