#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "part/bounds.hpp"
#include "touch/world.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad {

/// A scene's motion as `check` tells it.
struct MotionCheck {
  std::string name;  ///< motion_name()
  long ticks = 0;
  double rate_hz = 0, duration_s = 0;
  Bounds box_W;          ///< of the finger's whole way [m]
  double nearest_m = 0;  ///< of the finger's skin at its ticks; 0 where it touches something, or may
  std::string hint;  ///< that it touches nothing, goes far beyond the parts or far into a plane; else empty
};

/// The recording's file, or "[motion]".
std::string motion_name(const Scene& scene);

/// Goes along the motion, or along so many of its ticks as tell it.
/// @param world  what there is to touch; a part has its tree
MotionCheck look_at_motion(const Scene& scene, const LoadedMotion& motion, const World& world);

/// "... can be followed", with how long it takes and where it goes; ends with a newline.
std::string motion_text(const MotionCheck& motion, const std::string& scene_path);
/// @param warnings  what was said of how it was read, beside its hint
nlohmann::ordered_json motion_json(const MotionCheck& motion, std::vector<std::string> warnings);

}  // namespace fingerpad
