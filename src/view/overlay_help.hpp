#pragma once

#include "view/overlay.hpp"

namespace fingerpad {

/// The page of keys, in the middle of `room`; what has just been done is told in its head.
void paint_help(Drawing& drawing, const OverlayFacts& facts, const Box& room, double em);

}  // namespace fingerpad
