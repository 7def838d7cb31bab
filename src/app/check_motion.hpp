#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "contact/placed_surface.hpp"
#include "part/bounds.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad {

/// A scene's motion as `check` tells it.
struct MotionCheck {
  std::string name;  ///< the recording's file, or "[motion]"
  long ticks = 0;
  double rate_hz = 0, duration_s = 0;
  Bounds box_W;  ///< of the finger's whole way [m]
  double nearest_m =
      0;  ///< the finger's skin from what it comes nearest to at its ticks; 0 where it touches something
};

/// Goes along the motion, or along so many of its ticks as tell it.
/// @param surfaces  what there is to touch; a part has its tree
MotionCheck look_at_motion(const Scene& scene, const LoadedMotion& motion,
                           std::span<const PlacedSurface> surfaces);

/// "... can be followed", with how long it takes and where it goes; ends with a newline.
std::string motion_text(const MotionCheck& motion, const std::string& scene_path);
nlohmann::ordered_json motion_json(const MotionCheck& motion);
/// What is odd about where it goes: that it touches nothing, or goes far beyond what there is to touch. Empty
/// where nothing is.
/// @param surfaces  as look_at_motion's
std::string motion_hint(const MotionCheck& motion, std::span<const PlacedSurface> surfaces);

}  // namespace fingerpad
