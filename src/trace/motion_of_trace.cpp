#include "trace/motion_of_trace.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace fingerpad {
namespace {

/// How the finger lay at row i.
void take_direction(const std::string& path, std::size_t i, const TickRecord& row, Motion& motion) {
  if (!(std::abs(row.direction_W.norm() - 1) < 1e-6))
    throw refused(path, fmt::format("row {}: the finger's direction is no unit vector", i + 1));
  motion.direction_W.col(static_cast<Eigen::Index>(i)) = row.direction_W;
}

void take_attitude(const std::string& path, std::size_t i, const TickRecord& row, Motion& motion) {
  if (!(std::abs(row.attitude.norm() - 1) < 1e-6))
    throw refused(path, fmt::format("row {}: the finger's attitude is no unit quaternion", i + 1));
  motion.attitude.emplace_back(row.attitude[0], row.attitude[1], row.attitude[2], row.attitude[3]);
}

}  // namespace

Motion motion_of_trace(const Trace& trace, const std::string& path, bool reads_normal_force) {
  if (trace.rows.empty())
    throw refused(path, "the trace has no rows" + (trace.complete ? "" : ": it " + trace.cut));
  const auto count = static_cast<Eigen::Index>(trace.rows.size());
  Motion motion;
  motion.p_WQ.resize(3, count);
  if (trace.info.in_hand) motion.push_W_n.resize(3, count);
  if (trace.info.estimated) motion.velocity_W.resize(3, count);
  if (trace.info.turning) motion.direction_W.resize(3, count);
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    const TickRecord& row = trace.rows[i];
    if (i > 0 && !(row.t_s > motion.t_s.back())) {
      throw refused(
          path, fmt::format("row {}: time {} s does not come after {} s", i + 1, row.t_s, motion.t_s.back()));
    }
    const Vec3& place_W = trace.info.in_hand ? row.encoded_W : row.p_WQ;
    std::string fault = sample_fault(row.t_s, place_W);
    if (fault.empty() && reads_normal_force) fault = force_fault(row.normal_force_n);
    if (!fault.empty()) throw refused(path, fmt::format("row {}: {}", i + 1, fault));
    motion.t_s.push_back(row.t_s);
    const auto column = static_cast<Eigen::Index>(i);
    motion.p_WQ.col(column) = place_W;
    if (trace.info.in_hand) motion.push_W_n.col(column) = row.push_W_n;
    if (trace.info.estimated) motion.velocity_W.col(column) = row.velocity_W;
    if (trace.info.turning) take_direction(path, i, row, motion);
    if (trace.info.attitudes) take_attitude(path, i, row, motion);
    if (reads_normal_force) motion.normal_force_n.push_back(row.normal_force_n);
  }
  return motion;
}

}  // namespace fingerpad
