#include "grip_paths.hpp"

#include <cmath>
#include <gp_XY.hxx>

#include "grip.hpp"

namespace fingerpad::parts {
namespace {

using namespace grip_size;

constexpr double from_y = -4, rim_length = 30, rim_swings = 2.5, rim_swing_rad = 1.2, off_rim_axis = 5;
constexpr double boss_turn_rad = 5, boss_swings = 3.5, nearest = 0.8, reach = 2.4;

struct OnOutline {
  gp_XY at, outward;
};

/// The grip's outline from (x/2, from_y) up the side, round its corner and back along the next side.
OnOutline outline_at(double length) {
  const gp_XY centre(x / 2 - corner, y / 2 - corner);
  const double side = centre.Y() - from_y, arc = corner * M_PI / 2;
  if (length < side) return {gp_XY(x / 2, from_y + length), gp_XY(1, 0)};
  if (length > side + arc) return {gp_XY(centre.X() - (length - side - arc), y / 2), gp_XY(0, 1)};
  const double angle = (length - side) / corner;
  const gp_XY outward(std::cos(angle), std::sin(angle));
  return {centre + outward * corner, outward};
}

}  // namespace

gp_Pnt rim_guide(double along) {
  const OnOutline rim_at = outline_at(rim_length * along);
  const double tilt = M_PI / 4 + rim_swing_rad * std::sin(2 * M_PI * rim_swings * along);
  const gp_XY at = rim_at.at + rim_at.outward * (off_rim_axis * std::cos(tilt) - rim);
  return {at.X(), at.Y(), grip_top_mm(rim_at.at.X(), rim_at.at.Y()) - rim + off_rim_axis * std::sin(tilt)};
}

gp_Pnt boss_guide(double along) {
  const double angle = 0.4 + boss_turn_rad * along, swing = std::sin(2 * M_PI * boss_swings * along);
  const double from_wall = nearest + reach * std::pow((1 + swing) / 2, 2);
  const double above_top = nearest + reach * std::pow((1 - swing) / 2, 2);
  const double place_x = boss_x + (boss_radius + from_wall) * std::cos(angle);
  const double place_y = boss_y + (boss_radius + from_wall) * std::sin(angle);
  return {place_x, place_y, grip_top_mm(place_x, place_y) + above_top};
}

}  // namespace fingerpad::parts
