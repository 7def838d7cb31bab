#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/types.hpp"

namespace fingerpad {

/// From where everything is looked at.
struct LookFrom {
  Vec3 towards_eye_W = Vec3::UnitZ();  ///< unit
  Vec3 up_W = Vec3::UnitY();           ///< unit, across it
  double zoom = 1;                     ///< 1: all in sight
};

/// Azimuth from the front (the eye at -y) to the right (the eye at +x), elevation towards the top.
LookFrom look_from_angles(double azimuth_deg, double elevation_deg);

/// One of "front", "back", "left", "right", "top", "bottom", "isometric"; none for any other name.
std::optional<LookFrom> named_look(std::string_view name);

/// NAME or AZIMUTH,ELEVATION in degrees, either with ",ZOOM" behind it. Throws Error (usage, --camera).
LookFrom read_look(const std::string& text);

}  // namespace fingerpad
