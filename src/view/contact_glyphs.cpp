#include "view/contact_glyphs.hpp"

#include <algorithm>
#include <cmath>

#include "base/tangent_frame.hpp"

namespace fingerpad {
namespace {

/// The region as a translucent patch between rings, with its rim, lifted off the surface by `lift_mm`.
void add_region(ContactGlyphs& glyphs, const ContactMoment& moment, std::vector<std::vector<Vec3>> rings,
                const DrawSpace& space, double lift_mm, double rim_mm) {
  const bool holds = moment.row.phase == Phase::stick;
  const Colour colour = holds ? phase_colour(Phase::stick) : colours::grey;
  const Vec3 up = moment.row.normal_W * lift_mm;
  for (auto& ring : rings) {
    for (Vec3& point : ring) point = space.to_draw(point) + up;
  }
  glyphs.solid.tube(rings.back(), true, rim_mm, colour);
  if (!holds) return;
  const Colour tint = colour.with_opacity(0.35);
  glyphs.clear.fan(space.to_draw(moment.region->centre_W) + up, rings.front(), moment.row.normal_W, tint);
  for (std::size_t i = 1; i < rings.size(); ++i) {
    glyphs.clear.band(rings[i - 1], rings[i], moment.row.normal_W, tint);
  }
}

/// The finger towards its tip at Q: a fingertip of its radius, or a slender stylus for a point.
void add_finger(ContactGlyphs& glyphs, const ContactMoment& moment, const DrawSpace& space, double size_mm,
                const GlyphInk& ink) {
  Vec3 tip = space.to_draw(moment.row.p_WQ);
  // Pressed far into a small part it would be out of sight behind it: so it stands near the surface then.
  const double buried_mm = 1e3 * moment.row.depth_m - size_mm;
  if (moment.row.phase != Phase::free && buried_mm > 0) tip += buried_mm * moment.row.normal_W;
  const Vec3 back = -moment.finger_direction_W;
  const double radius_mm = moment.finger_radius_m * 1e3;
  if (radius_mm > 0) {
    // The bar's near end is within the ball, which is drawn over it.
    glyphs.clear.bar(tip, tip + back * std::max(ball_finger_radii * radius_mm, ball_finger_sizes * size_mm),
                     radius_mm, 0.85 * radius_mm, colours::skin.with_opacity(0.45));
    glyphs.clear.ball(tip, radius_mm, colours::skin.with_opacity(0.55));
    return;
  }
  glyphs.clear.bar(tip, tip + back * point_finger_sizes * size_mm, 0, 0.85 * size_mm,
                   colours::skin.with_opacity(0.8));
  glyphs.solid.ball(tip, 0.16 * size_mm, ink.line);
}

}  // namespace

ContactMoment contact_moment(const ViewInput& input, const TickRecord& row) {
  ContactMoment moment;
  moment.row = row;
  if (!input.scene) return moment;
  moment.finger_direction_W = finger_direction(input.scene->finger.direction, row);
  moment.finger_radius_m = input.scene->finger.radius_m;
  const auto surface = static_cast<std::size_t>(row.surface);
  if (row.surface >= 0 && input.world && surface < input.world->surfaces.size()) {
    moment.region = stick_region(*input.scene, input.world->surfaces[surface].properties, row);
    if (!moment.region) return moment;
    moment.region_reach_m = std::max(moment.region->axes.lateral_m, moment.region->axes.longitudinal_m);
    // Several walls have a region each, of which the record tells no more than the greatest wall's centre.
    if (row.walls > 1) moment.region.reset();
    if (moment.region) moment.rings = region_rings(*moment.region, input.world->surfaces[surface]);
  }
  return moment;
}

ContactGlyphs contact_glyphs(const ContactMoment& moment, const DrawSpace& space, const GlyphChoice& choice) {
  ContactGlyphs glyphs;
  const TickRecord& row = moment.row;
  const double size = choice.size_mm;
  if (choice.finger) add_finger(glyphs, moment, space, size, choice.ink);
  if (row.phase == Phase::free) return glyphs;

  const Vec3 contact = space.to_draw(row.contact_W);
  if (moment.region) add_region(glyphs, moment, moment.rings, space, 0.02 * size, 0.04 * size);
  glyphs.solid.ball(contact, 0.22 * size, phase_colour(row.phase));
  if (row.stick_centre_W.allFinite()) {
    const Vec3 centre = space.to_draw(row.stick_centre_W);
    // Of one of several walls it may stand a finger's radius off, and is looked for through the finger. Near
    // the contact a small one leaves that in sight.
    constexpr double large = 0.26;
    const bool stands_off = row.walls > 1 && (centre - contact).norm() > large * size;
    glyphs.solid.ball(centre, (stands_off ? large : 0.14) * size, choice.ink.centre);
  }
  if (choice.frame) {
    const Mat3 frame = tangent_frame(row.normal_W, moment.finger_direction_W);
    for (int axis = 0; axis < 3; ++axis) {
      glyphs.solid.arrow(contact, contact + frame.col(axis) * frame_axis_sizes(axis) * size, 0.05 * size,
                         choice.ink.line);
    }
  }
  if (choice.forces) {
    const auto force = [&](const Vec3& force_W_n, const Colour& colour) {
      glyphs.solid.arrow(contact, contact + force_W_n * choice.mm_per_n, 0.15 * size, colour);
    };
    force(row.force_W_n - row.friction_W_n, colours::blue);  // of several walls their resultant
    force(row.friction_W_n, colours::vermillion);
    glyphs.solid.arrow(contact, contact + row.force_W_n * choice.mm_per_n, 0.09 * size,
                       colours::reddish_purple);
  }
  return glyphs;
}

ContactGlyphs close_up_glyphs(const ContactMoment& moment, const DrawSpace& space, double limit_n,
                              double half_height_mm, const GlyphInk& ink) {
  ContactGlyphs glyphs;
  const TickRecord& row = moment.row;
  if (row.phase == Phase::free) return glyphs;
  const double unit = half_height_mm / 10;
  const Vec3 up = row.normal_W * 0.4 * unit;
  const Vec3 contact = space.to_draw(row.contact_W) + 2 * up;
  if (moment.region) {
    add_region(glyphs, moment, {rim_points(*moment.region, 90, 1)}, space, 0.4 * unit, 0.1 * unit);
    const Vec3 centre = space.to_draw(moment.region->centre_W) + up;
    glyphs.solid.tube({centre, contact}, false, 0.09 * unit, ink.line);
    if (row.phase == Phase::stick) glyphs.solid.ball(centre, 0.35 * unit, ink.centre);
  } else if (row.stick_centre_W.allFinite()) {
    glyphs.solid.ball(space.to_draw(row.stick_centre_W) + up, 0.35 * unit, ink.centre);
  }
  glyphs.solid.ball(contact, 0.45 * unit, phase_colour(row.phase));
  if (limit_n > 0) {
    glyphs.solid.arrow(contact + up, contact + up + row.friction_W_n / limit_n * 5 * unit, 0.2 * unit,
                       colours::vermillion);
  }
  return glyphs;
}

}  // namespace fingerpad
