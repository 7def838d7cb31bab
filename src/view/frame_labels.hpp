#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "view/drawing.hpp"
#include "view/overlay.hpp"

namespace fingerpad {

/// An arrow's axis on the screen, from its foot to its tip.
using ScreenArrow = std::pair<Vec2, Vec2>;

/// An axis of the tangent frame with its letters.
struct NamedAxis {
  std::string name;
  ScreenArrow on_screen;
};

/// Finds places for the letters of the axes: beyond the tip or beside it, clear of all arrows, of the letters
/// before and of the boxes over the scene. An axis seen from its end, or without a free place, has no
/// letters.
/// @param axes    in order of rank
/// @param arrows  what else is not to be written over: forces
/// @param within  letters stay in it
std::vector<OverlayFacts::Label> frame_labels(std::span<const NamedAxis> axes,
                                              std::span<const ScreenArrow> arrows, std::span<const Box> boxes,
                                              const Box& within, double em);

}  // namespace fingerpad
