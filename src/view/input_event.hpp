#pragma once

#include <functional>
#include <string>

namespace fingerpad {

/// What a person does at a window with the left button, the pointer or a key.
struct InputEvent {
  enum class Kind { press, move, release, key };
  Kind kind = Kind::move;
  double x_px = 0, y_px = 0;  ///< from the lower left corner
  std::string key = {};       ///< X key name, as "space"
  double t_s = 0;             ///< when it was done; steady clock
};

/// Takes an event before the window's thread has time for it, on whichever thread hears of it.
/// @returns whether the event was meant for it
using AtOnce = std::function<bool(const InputEvent&)>;

}  // namespace fingerpad
