#pragma once

#include <string>

#include "trace/trace.hpp"

namespace fingerpad {

class FingerPath;
struct Scene;

/// What a trace of this scene says of its motion's files: file_hash of each; empty where there is none.
std::string motion_hash_of(const Scene& scene);
/// What a trace of this scene says about itself.
TraceInfo trace_info(const Scene& scene, const World& world, const std::string& version);
/// Of a run along `path`.
TraceInfo trace_info(const Scene& scene, const World& world, const FingerPath& path,
                     const std::string& version);
/// Of one whose motion_hash_of is known.
TraceInfo trace_info(const Scene& scene, const World& world, const FingerPath& path,
                     const std::string& motion_hash, const std::string& version);

}  // namespace fingerpad
