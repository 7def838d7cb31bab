#include "motion/open_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/csv_header.hpp"
#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "motion/motion.hpp"
#include "motion/open_table.hpp"
#include "motion/pressed_force.hpp"
#include "motion/told_speed.hpp"

namespace fingerpad {
namespace {

/// What to do with a table of several trials.
constexpr std::string_view one_trial_mend =
    "one file is one trial here; part them into files, or have fit read it as a table of your own "
    "(--reader table, with subject=... and trial=... in --columns)";

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
    if (named_column(format, key).empty() && !(key == "z" && layout.is_planar)) open.push_back(key);
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
  const std::string_view beside = format.takes_torque ? ", tx, ty, tz, speed" : "";
  for (std::size_t k = 0; k < recording_columns.size(); ++k) {
    const std::string_view key = recording_columns[k].key;
    if (format.headers[k].empty() || std::find(std::begin(taken), std::end(taken), key) != std::end(taken))
      continue;
    throw refused(path, fmt::format("the column '{}' is named, which {} does not take (it takes {}{}): {}",
                                    key, layout.format, fmt::join(taken, ", "), beside,
                                    key == "trial" || key == "subject" ? one_trial_mend : "leave it out"));
  }
}

/// Those of the keys that the user has named.
std::vector<std::string_view> named_keys(const RecordingFormat& format,
                                         const std::vector<std::string_view>& keys) {
  std::vector<std::string_view> found;
  for (const std::string_view key : keys)
    if (!named_column(format, key).empty()) found.push_back(key);
  return found;
}

/// Positions, and how fast the recording says that they go.
void take_positions(const std::vector<std::string_view>& keys, const Eigen::MatrixXd& values,
                    FieldRecording& recording) {
  Motion& motion = recording.motion;
  motion.p_WQ = Points::Zero(3, values.cols());
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (keys[k] != "speed") motion.p_WQ.row(keys[k].front() - 'x') = values.row(static_cast<Eigen::Index>(k));
  if (keys.empty() || keys.back() != "speed") return;
  constexpr double most_off = 1.25;
  const Eigen::VectorXd speed = values.bottomRows(1).transpose();
  const double ratio =
      speed_over_positions(motion.t_s, motion.p_WQ, {speed.data(), static_cast<std::size_t>(speed.size())});
  std::string words = fmt::format("its speeds are {} times what its positions give", rounded_text(ratio, 3));
  if (!std::isfinite(ratio)) words = "its speeds could not be held against its positions, which hardly move";
  if (ratio > most_off || ratio < 1 / most_off) {
    recording.warnings.push_back(words +
                                 ": the unit of one of them, or of time, is not what it is taken for");
  } else {
    recording.notes.push_back(words);
  }
}

/// Torques on the finger, about the sensor's origin.
void take_torques(const std::string& path, const RecordingFormat& format,
                  const std::vector<std::string_view>& keys, const Eigen::MatrixXd& values,
                  FieldRecording& recording) {
  int components = 0;
  Points torque_n_m(3, values.cols());
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (quantity_of(keys[k]) != Quantity::torque) continue;
    torque_n_m.row(keys[k].back() - 'x') =
        (format.forces_on_surface ? -1 : 1) * values.row(static_cast<Eigen::Index>(k));
    ++components;
  }
  if (components == 0) return;
  if (components != 3)
    throw refused(path, "a torque needs all of tx, ty and tz; name them in columns, or none of them");
  recording.torque_W_n_m = std::move(torque_n_m);
  recording.notes.push_back(fmt::format(
      "torques up to {} N mm; they tell the contact point where --sensor-at says how the sensor stands",
      rounded_text(1e3 * recording.torque_W_n_m.colwise().norm().maxCoeff(), 3)));
}

void take_forces(const std::string& path, const RecordingFormat& format,
                 const std::vector<std::string_view>& keys, const Eigen::MatrixXd& values, Motion& motion) {
  refuse_words_of_no_force(path, format);
  const double sign = format.forces_on_surface ? -1 : 1;
  std::size_t components = 0;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (quantity_of(keys[k]) != Quantity::force) continue;
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
  if (components == 3 && !format.is_sensor_turned) {
    const std::vector<double> normal(motion.force_W_n.row(2).begin(), motion.force_W_n.row(2).end());
    const double usual_n = pressed_median_n(normal);
    if (usual_n < 0)
      throw refused(path,
                    fmt::format("its fz is {} N in the middle of the samples that press: pressed on "
                                "a surface the finger is pushed along the normal, so that forces on it "
                                "have fz above 0; {}",
                                rounded_text(usual_n, 3),
                                format.forces_on_surface
                                    ? "force_on = \"plate\" (--force-on plate) has turned it round: "
                                      "leave that out if it is the force on the finger"
                                    : "say force_on = \"plate\" (--force-on plate) if it is the load on "
                                      "the surface"));
    if (motion.normal_force_n.empty()) motion.normal_force_n = normal;
  }
}

/// Along the axis that they reach farthest along.
double reach_m(const Motion& motion) {
  return (motion.p_WQ.rowwise().maxCoeff() - motion.p_WQ.rowwise().minCoeff()).maxCoeff();
}

void refuse_odd_samples(const std::string& path, const Motion& motion) {
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    std::string fault = sample_fault(motion.t_s[i], motion.p_WQ.col(column));
    if (fault.empty() && i > 0 && !(motion.t_s[i] > motion.t_s[i - 1]))
      fault = fmt::format("time {} s does not come after {} s: {}", motion.t_s[i], motion.t_s[i - 1],
                          one_trial_mend);
    if (fault.empty() && !motion.normal_force_n.empty()) fault = force_fault(motion.normal_force_n[i]);
    if (!fault.empty()) throw refused(path, fmt::format("sample {}: {}", i + 1, fault));
  }
}

}  // namespace

FieldRecording read_open_layout(const std::string& path, const RecordingFormat& format,
                                const OpenLayout& layout) {
  ask_for_columns(path, format, layout);
  refuse_other_columns(path, format, layout);
  const auto places = named_keys(format, {"x", "y", "z", "speed"}),
             forces = named_keys(format, {"fx", "fy", "fz", "fn", "tx", "ty", "tz"});
  FieldRecording recording;
  Motion& motion = recording.motion;
  const auto take = [&](const Eigen::MatrixXd& position, const Eigen::MatrixXd& force) {
    take_positions(places, position, recording);
    take_forces(path, format, forces, force, motion);
    take_torques(path, format, forces, force, recording);
  };
  if (format.positions_path.empty()) {
    std::vector<std::string_view> keys = places;
    keys.insert(keys.end(), forces.begin(), forces.end());
    const ClockedValues all = clocked_columns(path, format, layout, keys, "samples", recording);
    motion.t_s = all.t_s;
    take(all.values.topRows(static_cast<Eigen::Index>(places.size())),
         all.values.bottomRows(static_cast<Eigen::Index>(forces.size())));
  } else {
    if (std::none_of(forces.begin(), forces.end(),
                     [](std::string_view key) { return quantity_of(key) == Quantity::force; }))
      throw refused(path,
                    "positions stand in a file of their own, and of this one no force is named in "
                    "columns: name fx, fy and fz, or fn");
    const JoinedClocks joined =
        join_clocks(clocked_columns(format.positions_path, format, layout, places, "positions", recording),
                    clocked_columns(path, format, layout, forces, "forces", recording), path);
    motion.t_s = joined.t_s;
    take(joined.first, joined.second);
    recording.notes.push_back(joined.note);
  }
  refuse_odd_samples(path, motion);
  recording.notes.push_back(fmt::format(
      "read as {}: positions over {} mm{}{}", layout.format, rounded_text(1e3 * reach_m(motion), 4),
      named_column(format, "z").empty() ? ", in the plane z = 0" : "",
      format.forces_on_surface ? "; forces turned to those on the finger" : ""));
  return recording;
}

std::vector<std::string> open_layout_files(const std::string& path, const RecordingFormat& format) {
  if (format.positions_path.empty()) return {path};
  return {path, format.positions_path};
}

}  // namespace fingerpad
