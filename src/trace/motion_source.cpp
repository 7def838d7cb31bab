#include "trace/motion_source.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "trace/trace.hpp"

namespace fingerpad {
namespace {

/// The finger's positions in a trace. A trace keeps no directions: the scene's holds.
Motion motion_of_trace(const std::string& path) {
  const Trace trace = read_trace(path, TraceContents::rows);
  if (trace.rows.empty()) throw refused(path, "the trace has no rows");
  Motion motion;
  motion.p_WQ.resize(3, static_cast<Eigen::Index>(trace.rows.size()));
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    const TickRecord& row = trace.rows[i];
    if (i > 0 && !(row.t_s > motion.t_s.back())) {
      throw refused(
          path, fmt::format("row {}: time {} s does not come after {} s", i + 1, row.t_s, motion.t_s.back()));
    }
    const std::string fault = sample_fault(row.t_s, row.p_WQ);
    if (!fault.empty()) throw refused(path, fmt::format("row {}: {}", i + 1, fault));
    motion.t_s.push_back(row.t_s);
    motion.p_WQ.col(static_cast<Eigen::Index>(i)) = row.p_WQ;
  }
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
