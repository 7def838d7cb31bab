#pragma once

#include "rub.hpp"

namespace fingerpad::parts {

/// The motion of the paper's figures 4 and 7: a point finger presses 2 mm into the plane z = 0 and moves,
/// without slipping, around just within the stick ellipse of scenes/profiles/soft_pad.toml, lifts, and does
/// so again with the finger at 15, 30, 45, 60 and 75 degrees to the plane. Lateral is x, longitudinal y.
std::vector<RubSample> pad_ellipses(double rate_hz);

/// The motion of the paper's figure 8: at 45 degrees, pressed 2 mm deep, two pushes to and fro along the
/// lateral axis and two along the longitudinal one, to nine tenths of the soft pad's axes.
std::vector<RubSample> pad_pushes(double rate_hz);

}  // namespace fingerpad::parts
