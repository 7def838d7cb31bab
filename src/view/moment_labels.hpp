#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "view/contact_glyphs.hpp"
#include "view/draw_space.hpp"
#include "view/layout.hpp"
#include "view/overlay.hpp"
#include "view/overlay_room.hpp"

namespace fingerpad {

/// The forces that are drawn as arrows: normal force, friction, and both.
std::array<Vec3, 3> drawn_forces_W_n(const TickRecord& row);

/// What the boxes over a scene leave in sight of a moment: the contact with the tips of its arrows, or the
/// finger in the air.
/// @param on_screen  where a place of the draw space is seen [px]
/// @param mm_per_n   of the arrows; 0: none are drawn
InSight moment_in_sight(const ContactMoment& moment, const DrawSpace& space,
                        const std::function<Vec2(const Vec3& p_mm)>& on_screen, double mm_per_n);

/// The letters of the tangent frame at a moment in contact, clear of its arrows and of the boxes over the
/// scene.
/// @param on_screen  where a place of the draw space is seen [px]
std::vector<OverlayFacts::Label> moment_labels(const ContactMoment& moment, const GlyphChoice& choice,
                                               const DrawSpace& space,
                                               const std::function<Vec2(const Vec3& p_mm)>& on_screen,
                                               std::span<const Box> boxes, const Layout& layout);

}  // namespace fingerpad
