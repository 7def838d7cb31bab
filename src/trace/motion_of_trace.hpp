#pragma once

#include <string>

#include "motion/motion.hpp"
#include "trace/trace.hpp"

namespace fingerpad {

/// The finger's way in a trace, as the run's friction was told it: of a hand the encoders' positions. Throws
/// Error (refused) where it has no rows, or one that no finger has gone through.
Motion motion_of_trace(const Trace& trace, const std::string& path, bool reads_normal_force);

}  // namespace fingerpad
