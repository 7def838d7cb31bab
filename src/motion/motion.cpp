#include "motion/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "motion/farthest.hpp"
#include "motion/pressed_force.hpp"

namespace fingerpad {
namespace {

/// Beyond the clocks that count from 1970, within what a double still resolves to microseconds.
constexpr double latest_s = 1e10;

RecordedTable read_table(const std::string& path, RecordingFormat& format) {
  CsvRequest request{{},
                     {},
                     format.dialect,
                     TableSource::file,
                     format.reads_normal_force
                         ? "say which of them stands for what, as in [motion] columns = { t = \"time\", "
                           "fn = \"press\" }, whose fn is the normal force"
                         : "say which of them stands for what, as in [motion] columns = { t = \"time\" }"};
  request.takes_units = request.takes_lines_above = true;
  request.mark_mend = separator_mend;
  request.decimal_key = "decimal = \"{}\" in [motion]";
  request.leaves_out_cut_row = format.ends_each_row;
  const AskedColumns asked = asked_columns(format);
  const auto optional = asked.names.begin() + static_cast<std::ptrdiff_t>(asked.required);
  request.required.assign(asked.names.begin(), optional);
  request.optional.assign(optional, asked.names.end());
  CsvColumns table = read_csv_columns(path, request);
  format.dialect.separator = table.separator;
  format.cut = table.cut;
  format.above = table.above;
  format.names = table.names;
  return recorded_table(path, std::move(table.columns), std::move(table.lines), asked, table.units, format);
}

/// @param is_twice  the same time, and not an earlier one
const char* mend_for_times(const RecordingFormat& format, bool is_twice) {
  if (format.trial && format.subject) return "";
  if (format.trial) return "; where subjects have trials of the same number, say 'subject' in [motion] too";
  return is_twice ? "; leave one of the two rows out; of a table of several trials say which one: 'trial' in "
                    "[motion] "
                    "(and 'subject')"
                  : "; sort the rows by time; of a table of several trials say which one: 'trial' in "
                    "[motion] (and "
                    "'subject')";
}

void check_times(const RecordedTable& recording, const RecordingFormat& format,
                 const std::vector<double>& t_s) {
  for (std::size_t i = 1; i < t_s.size(); ++i) {
    if (t_s[i] > t_s[i - 1]) continue;
    throw recording.fault(i, fmt::format("time {} s does not come after {} s{}", t_s[i], t_s[i - 1],
                                         mend_for_times(format, t_s[i] == t_s[i - 1])));
  }
}

void check_samples(const RecordedTable& recording, const Motion& motion) {
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const std::string fault = sample_fault(motion.t_s[i], motion.p_WQ.col(static_cast<Eigen::Index>(i)));
    if (!fault.empty()) throw recording.fault(i, fault);
  }
}

void read_directions(const RecordedTable& recording, Motion& motion) {
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

void read_attitudes(const RecordedTable& recording, Motion& motion) {
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

void read_normal_forces(const RecordedTable& recording, const RecordingFormat& format, Motion& motion) {
  motion.normal_force_n = recording.columns[place_of_fn];
  for (double& force_n : motion.normal_force_n) force_n *= format.newtons_per_unit;
  if (format.forces_on_surface) turn_to_finger(motion.normal_force_n);
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const std::string fault = force_fault(motion.normal_force_n[i]);
    if (!fault.empty()) throw recording.fault(i, fault);
  }
}

void read_forces(const RecordedTable& recording, const RecordingFormat& format, Motion& motion) {
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

void refuse_words_of_no_force(const std::string& path, const RecordingFormat& format) {
  if (!(format.forces_on_surface || format.says_force_unit) || format.reads_normal_force) return;
  for (const std::size_t k : {place_of_fx, place_of_fx + 1, place_of_fx + 2, place_of_fn})
    if (!format.headers[k].empty()) return;
  throw refused(
      path, fmt::format("{}, and none is read of it: name fx, fy and fz, or fn, in columns, or leave {} out",
                        format.forces_on_surface ? "force_on = \"plate\" says what a measured force acts on"
                                                 : "force_unit says what a measured force is in",
                        format.forces_on_surface ? "force_on" : "force_unit"));
}

Motion motion_of_table(const RecordedTable& recording, const RecordingFormat& format) {
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

Motion read_motion_csv(const std::string& path, RecordingFormat& format) {
  refuse_words_of_no_force(path, format);
  const RecordedTable recording = read_table(path, format);
  return motion_of_table(recording, format);
}

Motion read_motion_csv(const std::string& path) {
  RecordingFormat format;
  return read_motion_csv(path, format);
}

}  // namespace fingerpad
