#include "motion/motion.hpp"

#include <fmt/format.h>

#include "base/csv_columns.hpp"
#include "base/error.hpp"

namespace fingerpad {
namespace {

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

}  // namespace

Motion read_motion_csv(const std::string& path) {
  const CsvColumns table = read_csv_columns(path, {"t_s", "x_m", "y_m", "z_m"}, {"dx", "dy", "dz"});
  check_times(path, table);
  Motion motion;
  motion.t_s = table.columns[0];
  const auto n = static_cast<Eigen::Index>(motion.t_s.size());
  motion.p_WQ.resize(3, n);
  for (int axis = 0; axis < 3; ++axis)
    motion.p_WQ.row(axis) = row_of(table.columns[1 + static_cast<std::size_t>(axis)]);

  const int directions = table.present[4] + table.present[5] + table.present[6];
  if (directions == 0) return motion;
  if (directions != 3) throw refused(path + ":1", "the finger's direction needs all of dx, dy and dz");
  motion.direction_W.resize(3, n);
  for (int axis = 0; axis < 3; ++axis) {
    motion.direction_W.row(axis) = row_of(table.columns[4 + static_cast<std::size_t>(axis)]);
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const double length = motion.direction_W.col(i).stableNorm();
    if (!(length > 1e-6)) {
      throw refused(fmt::format("{}:{}", path, table.lines[static_cast<std::size_t>(i)]),
                    "dx,dy,dz name no direction");
    }
    motion.direction_W.col(i) /= length;
  }
  return motion;
}

}  // namespace fingerpad
