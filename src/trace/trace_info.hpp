#pragma once

#include <string>

#include "trace/trace.hpp"

namespace fingerpad {

struct Scene;

/// What a trace of this scene says about itself.
TraceInfo trace_info(const Scene& scene, const World& world, const std::string& version);

}  // namespace fingerpad
