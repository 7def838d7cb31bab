#pragma once

#include <optional>
#include <vector>

#include "view/overlay.hpp"
#include "view/overlay_places.hpp"

namespace fingerpad {

/// What the boxes over a scene are to leave in sight [px].
struct InSight {
  std::optional<Vec2> finger_px;  ///< the contact, or the finger in the air
  std::vector<Vec2> tips_px;      ///< of the arrows of forces
};

/// Finds room for readings, legend and close-up: none lies over the finger, and none over the arrows where
/// that is possible. Writes it into the facts, with whether the readings are brief.
/// @param places         that the boxes had before
/// @param wants_inset    the close-up is worth its room
void find_room(OverlayPlaces& places, OverlayFacts& facts, const ViewState& state, const Layout& layout,
               const InSight& in_sight, bool wants_inset);

/// Says how to find a finger that is beside the scene shown, where nothing else is said in that place.
void tell_lost_finger(OverlayFacts& facts, const Layout& layout);

}  // namespace fingerpad
