#pragma once

#include "view/overlay.hpp"

namespace fingerpad {

/// How wide the readings of a moment are.
inline constexpr double readings_width_em = 14.5;

/// The readings of the moment shown; where nothing moves, what there is to say of the parts.
Vec2 readings_size(const OverlayFacts& facts, double em);
void paint_readings(Drawing& drawing, const OverlayFacts& facts, const Box& box, double em);

/// What arrows and colours mean. (0, 0) where nothing is to be explained, or briefly.
Vec2 legend_size(const OverlayFacts& facts, const ViewState& state, double em);
void paint_legend(Drawing& drawing, const OverlayFacts& facts, const ViewState& state, const Box& box,
                  double em);

}  // namespace fingerpad
