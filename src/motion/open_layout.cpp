#include "motion/open_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/csv_columns.hpp"
#include "base/csv_header.hpp"
#include "base/error.hpp"
#include "base/printable_text.hpp"
#include "motion/joined_clocks.hpp"
#include "motion/motion.hpp"
#include "motion/pressed_force.hpp"

namespace fingerpad {
namespace {

std::string_view named(const RecordingFormat& format, std::string_view key) {
  return format.headers[recording_column_place(key)];
}

/// The names of a table's columns, as its first line that counts has them.
std::string names_in(const std::string& path) {
  TextLines lines(path, {"a table", std::uint64_t{2} << 30, false});
  std::string names, comment;
  for (std::string_view line; lines.next(line);) {
    const std::string_view text = trimmed(line);
    if (text.empty()) continue;
    names = text.front() == '#' ? text.substr(1) : text;
    if (text.front() != '#') break;
  }
  return printable(std::string(trimmed(names)), 300);
}

void ask_for_columns(const std::string& path, const RecordingFormat& format, const OpenLayout& layout) {
  std::vector<std::string_view> open;
  for (const std::string_view key : {"t", "x", "y", "z"}) {
    if (named(format, key).empty() && !(key == "z" && layout.is_planar)) open.push_back(key);
  }
  if (open.empty()) return;
  throw refused(
      path,
      fmt::format("the published description of {} does not name its columns, so they are not guessed: "
                  "say which is {} (and fx, fy, fz of a force, fz along the surface's normal, or fn of "
                  "a normal force alone), as in columns = {{ t = \"...\", x = \"...\" }} of [motion] or "
                  "--columns t=...,x=...; its first line is '{}'",
                  layout.format, fmt::join(open, ", "), names_in(path)));
}

void refuse_other_columns(const std::string& path, const RecordingFormat& format, const OpenLayout& layout) {
  constexpr std::string_view taken[] = {"t", "x", "y", "z", "fx", "fy", "fz", "fn"};
  for (std::size_t k = 0; k < recording_columns.size(); ++k) {
    const std::string_view key = recording_columns[k].key;
    if (format.headers[k].empty() || std::find(std::begin(taken), std::end(taken), key) != std::end(taken))
      continue;
    throw refused(path,
                  fmt::format("the column '{}' is named, which {} does not take (it takes {}): leave it "
                              "out",
                              key, layout.format, fmt::join(taken, ", ")));
  }
}

double ask_for_metres(const std::string& path, const RecordingFormat& format, const OpenLayout& layout) {
  if (format.says_unit) return format.metres_per_unit;
  if (layout.metres_per_unit > 0) return layout.metres_per_unit;
  throw refused(path, fmt::format("the published description of {} does not say the unit of its positions: "
                                  "say unit = \"mm\" (or m, cm, in) in [motion], or --unit",
                                  layout.format));
}

/// Columns of one table, with a time in seconds.
ClockedValues clocked_columns(const std::string& path, const RecordingFormat& format,
                              const std::vector<std::string_view>& keys, std::string what) {
  CsvRequest request;
  request.dialect = format.dialect;
  request.required.push_back(named(format, "t"));
  for (const std::string_view key : keys) request.required.push_back(named(format, key));
  const CsvColumns table = read_csv_columns(path, request);
  if (table.lines.empty()) throw refused(path, "has a header but no rows");
  ClockedValues read{std::move(what), table.columns.front(), {}};
  for (double& t_s : read.t_s) t_s *= format.says_time_unit ? format.seconds_per_unit : 1;
  read.values.resize(static_cast<Eigen::Index>(keys.size()), static_cast<Eigen::Index>(read.t_s.size()));
  for (std::size_t k = 0; k < keys.size(); ++k) {
    read.values.row(static_cast<Eigen::Index>(k)) = Eigen::Map<const Eigen::RowVectorXd>(
        table.columns[k + 1].data(), static_cast<Eigen::Index>(read.t_s.size()));
  }
  return read;
}

/// Those of the keys that the user has named.
std::vector<std::string_view> named_keys(const RecordingFormat& format,
                                         const std::vector<std::string_view>& keys) {
  std::vector<std::string_view> found;
  for (const std::string_view key : keys)
    if (!named(format, key).empty()) found.push_back(key);
  return found;
}

void take_positions(const std::vector<std::string_view>& keys, const Eigen::MatrixXd& values, double metres,
                    Motion& motion) {
  motion.p_WQ = Points::Zero(3, values.cols());
  for (std::size_t k = 0; k < keys.size(); ++k)
    motion.p_WQ.row(keys[k].front() - 'x') = metres * values.row(static_cast<Eigen::Index>(k));
}

void take_forces(const std::string& path, const RecordingFormat& format,
                 const std::vector<std::string_view>& keys, const Eigen::MatrixXd& values, Motion& motion) {
  refuse_side_of_no_force(path, format);
  const double sign = format.forces_on_surface ? -1 : 1;
  std::size_t components = 0;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const auto row = values.row(static_cast<Eigen::Index>(k));
    if (keys[k] == "fn") {
      motion.normal_force_n.assign(row.begin(), row.end());
      if (format.forces_on_surface) turn_to_finger(motion.normal_force_n);
      continue;
    }
    if (components++ == 0) motion.force_W_n.resize(3, values.cols());
    motion.force_W_n.row(keys[k].back() - 'x') = sign * row;
  }
  if (components != 0 && components != 3)
    throw refused(path, "a force needs all of fx, fy and fz; name them in columns, or none of them");
  if (components == 3) {
    const std::vector<double> normal(motion.force_W_n.row(2).begin(), motion.force_W_n.row(2).end());
    const double usual_n = pressed_median_n(normal);
    if (usual_n < 0)
      throw refused(path,
                    fmt::format("its fz is {:.3g} N in the middle of the samples that press: pressed on "
                                "a surface the finger is pushed along the normal, so that forces on it "
                                "have fz above 0; say force_on = \"plate\" (--force-on plate) if it "
                                "is the load on the surface",
                                usual_n));
    if (motion.normal_force_n.empty()) motion.normal_force_n = normal;
  }
}

void refuse_odd_samples(const std::string& path, const Motion& motion) {
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    std::string fault = sample_fault(motion.t_s[i], motion.p_WQ.col(column));
    if (fault.empty() && i > 0 && !(motion.t_s[i] > motion.t_s[i - 1]))
      fault = fmt::format("time {} s does not come after {} s", motion.t_s[i], motion.t_s[i - 1]);
    if (fault.empty() && !motion.normal_force_n.empty()) fault = force_fault(motion.normal_force_n[i]);
    if (!fault.empty()) throw refused(path, fmt::format("sample {}: {}", i + 1, fault));
  }
}

}  // namespace

std::size_t recording_column_place(std::string_view key) noexcept {
  const auto found = std::find_if(recording_columns.begin(), recording_columns.end(),
                                  [key](const RecordingColumn& column) { return column.key == key; });
  return static_cast<std::size_t>(found - recording_columns.begin());
}

FieldRecording read_open_layout(const std::string& path, const RecordingFormat& format,
                                const OpenLayout& layout) {
  ask_for_columns(path, format, layout);
  refuse_other_columns(path, format, layout);
  const double metres = ask_for_metres(path, format, layout);
  const auto places = named_keys(format, {"x", "y", "z"}),
             forces = named_keys(format, {"fx", "fy", "fz", "fn"});
  FieldRecording recording;
  Motion& motion = recording.motion;
  if (format.positions_path.empty()) {
    std::vector<std::string_view> keys = places;
    keys.insert(keys.end(), forces.begin(), forces.end());
    const ClockedValues all = clocked_columns(path, format, keys, "samples");
    motion.t_s = all.t_s;
    take_positions(places, all.values.topRows(static_cast<Eigen::Index>(places.size())), metres, motion);
    take_forces(path, format, forces, all.values.bottomRows(static_cast<Eigen::Index>(forces.size())),
                motion);
  } else {
    if (forces.empty())
      throw refused(path,
                    "positions stand in a file of their own, and of this one no force is named in "
                    "columns: name fx, fy and fz, or fn");
    const JoinedClocks joined =
        join_clocks(clocked_columns(format.positions_path, format, places, "positions"),
                    clocked_columns(path, format, forces, "forces"), path);
    motion.t_s = joined.t_s;
    take_positions(places, joined.first, metres, motion);
    take_forces(path, format, forces, joined.second, motion);
    recording.notes.push_back(joined.note);
  }
  refuse_odd_samples(path, motion);
  recording.notes.push_back(
      fmt::format("read as {}: positions of {} m a unit{}{}", layout.format, metres,
                  places.size() == 2 ? ", in the plane z = 0" : "",
                  format.forces_on_surface ? "; forces turned to those on the finger" : ""));
  return recording;
}

std::vector<std::string> open_layout_files(const std::string& path, const RecordingFormat& format) {
  if (format.positions_path.empty()) return {path};
  return {path, format.positions_path};
}

}  // namespace fingerpad
