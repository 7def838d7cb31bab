#pragma once

#include "view/overlay.hpp"

namespace fingerpad {

/// Where what is missing in the picture is told: at the foot of the scene between the legend and the scale
/// bar, over the legend where there is too little room; empty where nothing is missing.
Box notice_box(const OverlayFacts& facts, const Layout& layout);
void paint_notice(Drawing& drawing, const OverlayFacts& facts, const Layout& layout);

}  // namespace fingerpad
