#include "motion/motion.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "motion/farthest.hpp"

namespace fingerpad {
namespace {

/// Beyond the clocks that count from 1970, within what a double still resolves to microseconds.
constexpr double latest_s = 1e10;

Eigen::Map<const Eigen::RowVectorXd> row_of(const std::vector<double>& column) {
  return {column.data(), static_cast<Eigen::Index>(column.size())};
}

void check_times(const std::string& path, const CsvColumns& table) {
  const std::vector<double>& t_s = table.columns[0];
  if (t_s.empty()) throw refused(path, "has a header but no rows");
  for (std::size_t i = 1; i < t_s.size(); ++i) {
    if (t_s[i] > t_s[i - 1]) continue;
    throw refused(fmt::format("{}:{}", path, table.lines[i]),
                  fmt::format("time {} s does not come after {} s", t_s[i], t_s[i - 1]));
  }
}

void check_samples(const std::string& path, const CsvColumns& table, const Motion& motion) {
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const std::string fault = sample_fault(motion.t_s[i], motion.p_WQ.col(static_cast<Eigen::Index>(i)));
    if (!fault.empty()) throw refused(fmt::format("{}:{}", path, table.lines[i]), fault);
  }
}

void read_directions(const std::string& path, const CsvColumns& table, Motion& motion) {
  const int columns = table.present[4] + table.present[5] + table.present[6];
  if (columns == 0) return;
  if (columns != 3) throw refused(path + ":1", "the finger's direction needs all of dx, dy and dz");
  motion.direction_W.resize(3, motion.p_WQ.cols());
  for (int axis = 0; axis < 3; ++axis) {
    motion.direction_W.row(axis) = row_of(table.columns[4 + static_cast<std::size_t>(axis)]);
  }
  for (Eigen::Index i = 0; i < motion.p_WQ.cols(); ++i) {
    const double length = motion.direction_W.col(i).stableNorm();
    if (!(length > 1e-6) || !std::isfinite(length)) {
      throw refused(fmt::format("{}:{}", path, table.lines[static_cast<std::size_t>(i)]),
                    "dx,dy,dz name no direction");
    }
    motion.direction_W.col(i) /= length;
  }
}

/// Unit to within what a recording's few digits leave.
constexpr double unit_tolerance = 1e-3;

void read_attitudes(const std::string& path, const CsvColumns& table, Motion& motion) {
  const int columns = table.present[7] + table.present[8] + table.present[9] + table.present[10];
  if (columns == 0) return;
  if (columns != 4) throw refused(path + ":1", "the finger's orientation needs all of qw, qx, qy and qz");
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    const Eigen::Vector4d q(table.columns[7][i], table.columns[8][i], table.columns[9][i],
                            table.columns[10][i]);
    const double length = q.stableNorm();
    if (!(std::abs(length - 1) <= unit_tolerance)) {
      throw refused(fmt::format("{}:{}", path, table.lines[i]),
                    fmt::format("qw,qx,qy,qz is no unit quaternion: its length is {}", length));
    }
    motion.attitude.emplace_back(q[0] / length, q[1] / length, q[2] / length, q[3] / length);
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

Motion read_motion_csv(const std::string& path) {
  const CsvColumns table =
      read_csv_columns(path, {"t_s", "x_m", "y_m", "z_m"}, {"dx", "dy", "dz", "qw", "qx", "qy", "qz"});
  check_times(path, table);
  Motion motion;
  motion.t_s = table.columns[0];
  motion.p_WQ.resize(3, static_cast<Eigen::Index>(motion.t_s.size()));
  for (int axis = 0; axis < 3; ++axis)
    motion.p_WQ.row(axis) = row_of(table.columns[1 + static_cast<std::size_t>(axis)]);
  check_samples(path, table, motion);
  read_directions(path, table, motion);
  read_attitudes(path, table, motion);
  return motion;
}

}  // namespace fingerpad
