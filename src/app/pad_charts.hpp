#pragma once

#include "study/report.hpp"
#include "view/view_input.hpp"

namespace fingerpad {

/// Where the contact point was relative to the stick centre, across and along the finger, by the finger's
/// inclination; the law's stick region dashed (paper, figs. 4 and 7).
/// Throws Error (refused) for a trace without stick, or without its scene (which knows the finger).
Chart stick_region_chart(const ViewInput& input);

/// Friction against displacement from the stick centre, across and along the finger (paper, fig. 8).
/// Errors as stick_region_chart.
Chart force_displacement_chart(const ViewInput& input);

}  // namespace fingerpad
