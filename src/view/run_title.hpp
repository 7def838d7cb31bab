#pragma once

#include <string>

#include "trace/trace.hpp"

namespace fingerpad {

/// What a picture of a run is headed with: "t: knob.stl · job 3 · mu_static 0.3". The job is told by the
/// file's name, what varies by the jobs.csv beside it, where there is one. A trace without a name has its
/// file's.
/// @param path  of the trace
std::string run_title(const TraceInfo& info, const std::string& path);

/// What such a title says of a set's job: "job 3, mu_static 0.3"; empty where it says nothing of one.
std::string varied_words(const std::string& title);

/// Its scene and meshes alone: "t: knob.stl".
std::string scene_title(const TraceInfo& info, const std::string& path);

}  // namespace fingerpad
