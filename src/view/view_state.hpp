#pragma once

#include <optional>

#include "view/camera_look.hpp"

#include <string>

namespace fingerpad {

/// What a path's colour says.
enum class PathColouring { phase, force };

/// What is shown and how; a window's keys change it.
struct ViewState {
  PathColouring colouring = PathColouring::phase;
  bool path = true, finger = true, forces = true, frame = true, close_up = true, creases = true, hud = true;
  bool help = false;
  bool wireframe = false, dark = false;
  std::optional<LookFrom> look = {};  ///< the view at first; none: the contact from its outside
  bool playing = false;
  double speed = 1;  ///< of playing, against the clock
};

}  // namespace fingerpad
