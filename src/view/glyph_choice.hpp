#pragma once

#include "view/contact_glyphs.hpp"
#include "view/layout.hpp"
#include "view/view_state.hpp"

namespace fingerpad {

/// GlyphChoice::size_mm on the screen [em].
inline constexpr double glyph_size_em = 1.15;

/// What a view draws of a moment, and how large: marks that read well at its size, and arrows of which the
/// longest takes a third of it.
/// @param px_per_mm      of the scene
/// @param arrow_force_n  of an arrow of full length
GlyphChoice glyph_choice(const ViewState& state, const Layout& layout, double px_per_mm,
                         double arrow_force_n);

}  // namespace fingerpad
