#pragma once

#include <optional>

#include "view/draw_space.hpp"
#include "view/glyph_mesh.hpp"
#include "view/stick_region.hpp"

namespace fingerpad {

/// One moment of a touch with all that a picture of it needs.
struct ContactMoment {
  TickRecord row;
  std::optional<StickRegion> region;     ///< empty while free, on several walls, and for laws without one
  double region_reach_m = 0;             ///< its greater axis, on several walls too; 0: the law has none
  std::vector<std::vector<Vec3>> rings;  ///< of the region, on the surface; see region_rings
  Vec3 finger_direction_W = -Vec3::UnitZ();
  double finger_radius_m = 0;
};

ContactMoment contact_moment(const ViewInput& input, const TickRecord& row);

/// The colours of what is neither a force nor a phase: lines, and the ball at the stick centre. On the dark
/// between a part's wires they are bright.
struct GlyphInk {
  Colour line = colours::ink, centre = colours::black;
};

/// What to draw, and how large.
struct GlyphChoice {
  double size_mm = 1;   ///< a length that reads well: about a thirtieth of the view
  double mm_per_n = 1;  ///< of force arrows
  bool finger = true, forces = true, frame = true;
  GlyphInk ink;
};

/// The solids that show a moment, opaque and translucent apart.
struct ContactGlyphs {
  GlyphMesh solid, clear;
};

/// How long the finger is drawn from its tip on: a point so many sizes, a ball so many, and of its own radii.
inline constexpr double point_finger_sizes = 7, ball_finger_sizes = 3, ball_finger_radii = 4;

/// How long the frame's axes are drawn: n beyond the others [GlyphChoice::size_mm].
constexpr double frame_axis_sizes(int axis) {
  return axis == 2 ? 3.0 : 2.2;
}

/// The finger, the contact point, the tangent frame (Cx across the finger, Cy along it, n outwards), the
/// stick region and its centre at true place and size, and the forces on the finger.
ContactGlyphs contact_glyphs(const ContactMoment& moment, const DrawSpace& space, const GlyphChoice& choice);

/// The contact from near by, for an inset: region, centre, spring and friction, which is drawn as long as the
/// region is wide at the static limit.
/// @param limit_n  mu_s n at this moment [N]
ContactGlyphs close_up_glyphs(const ContactMoment& moment, const DrawSpace& space, double limit_n,
                              double half_height_mm, const GlyphInk& ink);

}  // namespace fingerpad
