#pragma once

#include <string>
#include <vector>

#include "view/compared_run.hpp"

namespace fingerpad {

/// What was measured along a trace's motion and what the model made of it, laid over one another: the whole
/// force on the finger along the world's axes (fx_n, fy_n, fz_n), those that change. Throws Error (refused)
/// for a trace that has no residual (rfx_n), and as read_trace.
/// @param from_s, to_s  what is earlier or later is left out
std::vector<ComparedRun> read_measured_and_model(const std::string& path, Over over, double from_s,
                                                 double to_s);

}  // namespace fingerpad
