#pragma once

#include "view/view_input.hpp"

namespace fingerpad {

/// From where the finger's contacts are seen, and no wall before them: the wanted direction where it shows
/// the one that is shown and half of all others, else the one of many that shows most, widely open ones and
/// those near the wanted one first. The wanted one, too, where none shows any, as in a closed hollow. Asks
/// the parts' trees; a part without one hides nothing.
/// @param shown  the tick that is; null, or free: the most telling one (telling_row)
/// @param towards_eye_W  wanted, unit
/// @returns unit
Vec3 free_sight(const ViewInput& input, const TickRecord* shown, const Vec3& towards_eye_W);

}  // namespace fingerpad
