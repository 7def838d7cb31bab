#pragma once

#include <string>

namespace fingerpad {

/// What a path's colour says.
enum class PathColouring { phase, force };

/// What is shown and how; a window's keys change it.
struct ViewState {
  PathColouring colouring = PathColouring::phase;
  bool path = true, finger = true, forces = true, frame = true, close_up = true, creases = true, hud = true;
  bool help = false;
  bool playing = false;
  double speed = 1;  ///< of playing, against the clock
};

}  // namespace fingerpad
