#include <algorithm>

#include "view/axis.hpp"
#include "view/glyph_choice.hpp"
#include "view/theme_device_vtk.hpp"

namespace fingerpad {
namespace {

/// A part's faces are bright in the dark, too; between its wires it is dark.
GlyphInk glyph_ink(const ViewState& state) {
  if (!state.dark || !state.wireframe) return {};
  return {in_the_dark(colours::ink), in_the_dark(colours::black)};
}

}  // namespace

GlyphChoice glyph_choice(const ViewState& state, const Layout& layout, double px_per_mm,
                         double arrow_force_n) {
  GlyphChoice choice;
  choice.size_mm = glyph_size_em * layout.em / px_per_mm;
  const double longest_mm = 0.3 * std::min(layout.scene.width, layout.scene.height) / px_per_mm;
  choice.mm_per_n = round_down_125(longest_mm / arrow_force_n);
  choice.finger = state.finger;
  choice.forces = state.forces;
  choice.frame = state.frame;
  choice.ink = glyph_ink(state);
  return choice;
}

}  // namespace fingerpad
