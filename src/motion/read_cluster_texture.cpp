#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/number_text.hpp"
#include "motion/field_format.hpp"
#include "motion/joined_clocks.hpp"

// Cluster Haptic Texture Dataset (Eguchi, Hayase, Hiroi, Hiraki 2024, arXiv:2407.16206;
// doi:10.6084/m9.figshare.29438288). Its dataset_details.md, of which the excerpts of files below are too,
// says:
//   sensor_data/force/NAME.csv     time,force    s, N    6 kHz   0.0009990528727670048,1.009
//   sensor_data/position/NAME.csv  time,X,Y      s, mm   100 Hz  0.000613,0.0,45.0
//   sensor_data/accel/NAME.csv     time,X,Y,Z    s, g    6 kHz
//   NAME = texture_direction_velocity_force_repeat, such as 0_135_40_500_0
// One computer's clock stands in all of them; the accelerations may be missing. The force is that of a load
// cell, pressed: normal force alone, and above 0. Not verified: real files, beyond those excerpts; how the
// accelerometer's axes lie to those of positions. The artificial finger is of urethane rubber.

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// NAME.csv in the sibling folder; empty where the file's own folder is none of the dataset's.
std::string cluster_sibling(const std::string& path, const char* folder) {
  const fs::path file(path);
  const std::string own = file.parent_path().filename().string();
  if (own != "force" && own != "position" && own != "accel") return "";
  return (file.parent_path().parent_path() / folder / file.filename()).string();
}

ClockedValues cluster_table(const std::string& path, const std::vector<std::string_view>& names,
                            std::string what) {
  const CsvColumns table = read_csv_columns(path, names);
  ClockedValues read{std::move(what), table.columns.front(), {}};
  read.values.resize(static_cast<Eigen::Index>(names.size()) - 1, static_cast<Eigen::Index>(read.t_s.size()));
  for (std::size_t k = 1; k < names.size(); ++k) {
    read.values.row(static_cast<Eigen::Index>(k) - 1) = Eigen::Map<const Eigen::RowVectorXd>(
        table.columns[k].data(), static_cast<Eigen::Index>(read.t_s.size()));
  }
  return read;
}

std::vector<std::string> cluster_files(const std::string& path, const RecordingFormat&) {
  if (cluster_sibling(path, "force").empty()) return {path};
  std::vector<std::string> files{cluster_sibling(path, "force"), cluster_sibling(path, "position")};
  if (fs::exists(cluster_sibling(path, "accel"))) files.push_back(cluster_sibling(path, "accel"));
  return files;
}

/// Tells in its notes how great the accelerations beside a recording are, at its times: neither a motion nor
/// a fit asks for more of them.
void tell_cluster_accelerations(const std::string& path, FieldRecording& recording) {
  constexpr double m_per_s2 = 9.80665;  // of a g
  const std::string accel = cluster_sibling(path, "accel");
  if (!fs::exists(accel)) {
    recording.notes.emplace_back("no accelerations: no file of this name in a folder 'accel' beside it");
    return;
  }
  const ClockedValues table = cluster_table(accel, {"time", "X", "Y", "Z"}, "accelerations");
  const Eigen::MatrixXd values = m_per_s2 * values_at(table, recording.motion.t_s, accel);
  double squares = 0, count = 0;
  for (Eigen::Index i = 0; i < values.cols(); ++i) {
    if (!values.col(i).allFinite()) continue;
    squares += values.col(i).squaredNorm();
    ++count;
  }
  if (!(count > 0)) throw refused(accel, "has no time in common with its forces and positions");
  recording.notes.push_back(
      fmt::format("accelerations read at {:.0f} of {} times, straight between their samples: {} m/s^2 RMS",
                  count, values.cols(), rounded_text(std::sqrt(squares / count), 3)));
}

FieldRecording read_cluster_texture(const std::string& path, const RecordingFormat&) {
  if (cluster_sibling(path, "force").empty())
    throw refused(path,
                  "a recording of the Cluster Haptic Texture Dataset stands in a folder 'force', with its "
                  "positions under the same name in a folder 'position' beside that");
  const JoinedClocks joined =
      join_clocks(cluster_table(cluster_sibling(path, "position"), {"time", "X", "Y"}, "positions"),
                  cluster_table(cluster_sibling(path, "force"), {"time", "force"}, "forces"), path);
  FieldRecording recording;
  Motion& motion = recording.motion;
  motion.t_s = joined.t_s;
  motion.p_WQ = Points::Zero(3, joined.first.cols());
  motion.p_WQ.topRows(2) = 1e-3 * joined.first;
  const auto force_n = joined.second.row(0);
  motion.normal_force_n.assign(force_n.begin(), force_n.end());
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    std::string fault = sample_fault(motion.t_s[i], motion.p_WQ.col(static_cast<Eigen::Index>(i)));
    if (fault.empty()) fault = force_fault(motion.normal_force_n[i]);
    if (!fault.empty()) throw refused(path, fmt::format("sample {}: {}", i + 1, fault));
  }
  recording.notes = {joined.note,
                     "read as cluster-texture: normal force alone, positions in the plane z = 0"};
  try {
    tell_cluster_accelerations(path, recording);
  } catch (const Error& error) {  // they move no finger: a recording is none the worse for them
    recording.notes.push_back(fmt::format("no accelerations: {}", error.what()));
  }
  return recording;
}

}  // namespace

FieldFormat cluster_texture_format() noexcept {
  return {
      "cluster-texture",
      "Cluster Haptic Texture Dataset: the file of forces, with its positions found beside it; normal force "
      "alone",
      "an artificial finger of rubber",
      false,
      cluster_files,
      read_cluster_texture,
      {}};
}

}  // namespace fingerpad
