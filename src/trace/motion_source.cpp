#include "trace/motion_source.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "trace/trace.hpp"

namespace fingerpad {
namespace {

/// How the finger lay at row i.
void take_turn(const std::string& path, std::size_t i, const TickRecord& row, Motion& motion) {
  if (!(std::abs(row.direction_W.norm() - 1) < 1e-6))
    throw refused(path, fmt::format("row {}: the finger's direction is no unit vector", i + 1));
  motion.direction_W.col(static_cast<Eigen::Index>(i)) = row.direction_W;
  if (row.attitude.hasNaN()) return;
  if (!(std::abs(row.attitude.norm() - 1) < 1e-6))
    throw refused(path, fmt::format("row {}: the finger's attitude is no unit quaternion", i + 1));
  motion.attitude.emplace_back(row.attitude[0], row.attitude[1], row.attitude[2], row.attitude[3]);
}

/// The finger's way in a trace, as the run's friction was told it: of a hand the encoders' positions.
Motion motion_of_trace(const std::string& path) {
  const Trace trace = read_trace(path, TraceContents::rows);
  if (trace.rows.empty()) throw refused(path, "the trace has no rows");
  const auto count = static_cast<Eigen::Index>(trace.rows.size());
  Motion motion;
  motion.p_WQ.resize(3, count);
  motion.encoder_m = trace.info.encoder_m;
  if (trace.info.in_hand) motion.push_W_n.resize(3, count);
  if (trace.info.turning) motion.direction_W.resize(3, count);
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    const TickRecord& row = trace.rows[i];
    if (i > 0 && !(row.t_s > motion.t_s.back())) {
      throw refused(
          path, fmt::format("row {}: time {} s does not come after {} s", i + 1, row.t_s, motion.t_s.back()));
    }
    const Vec3& place_W = trace.info.in_hand ? row.encoded_W : row.p_WQ;
    const std::string fault = sample_fault(row.t_s, place_W);
    if (!fault.empty()) throw refused(path, fmt::format("row {}: {}", i + 1, fault));
    motion.t_s.push_back(row.t_s);
    const auto column = static_cast<Eigen::Index>(i);
    motion.p_WQ.col(column) = place_W;
    if (trace.info.in_hand) motion.push_W_n.col(column) = row.push_W_n;
    if (trace.info.turning) take_turn(path, i, row, motion);
  }
  if (!motion.attitude.empty() && motion.attitude.size() != trace.rows.size())
    throw refused(path, "some of its rows have an attitude of the finger and some have none");
  return motion;
}

}  // namespace

FingerPath load_finger_path(const Scene& scene) {
  const MotionSettings& motion = scene.motion;
  if (!motion.given()) {
    throw refused(scene.path, "the scene has no motion to follow; give [motion] a 'file' or a 'kind'");
  }
  if (motion.scripted) return {*motion.scripted, motion.rate_hz, scene.finger.direction};
  Motion recorded =
      is_hdf5(motion.file_path) ? motion_of_trace(motion.file_path) : read_motion_csv(motion.file_path);
  try {
    return {std::move(recorded), motion.rate_hz, scene.finger.direction};
  } catch (const Error& too_long) {
    throw refused(motion.file_path, too_long.what());
  }
}

}  // namespace fingerpad
