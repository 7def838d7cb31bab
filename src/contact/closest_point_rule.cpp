#include "contact/closest_point_rule.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/number_text.hpp"
#include "contact/contact_method_table.hpp"
#include "contact/part_measures.hpp"

namespace fingerpad {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double right_angle_rad = std::numbers::pi / 2;
/// Radii are told from uneven meshes to a fifth: a sphere as deep as the press is not to count as tighter.
constexpr double round_known_to = 0.8;

std::string millimetres(double length_m) {
  return fmt::format("{} mm", rounded_text(1e3 * length_m, 3));
}

/// Why the part's inside is not known; empty where it is.
std::string unknown_inside(const PartMeasures& part) {
  if (part.open_edges > 0)
    return fmt::format("the mesh is not closed ({} edges without one neighbour)", part.open_edges);
  if (part.contradicting_edges > 0) return "its facets are wound against each other";
  if (part.overlap_count > 0)
    return "it overlaps itself, and inside of another body the nearest surface is no wall";
  return part.volume_m3 < 0 ? "it is inside out" : "";
}

/// Why a pressed finger would come out on the far side; empty where it would not.
std::string way_through(const ContactDemand& demand) {
  const PartMeasures& part = demand.part;
  if (demand.centre_depth_m <= 0) return {};
  if (part.thinnest_m <= 2 * demand.centre_depth_m) {
    if (part.thinnest_wall_m <= 2 * demand.centre_depth_m)
      return fmt::format("walls are {} thick and {}", millimetres(part.thinnest_wall_m), demand.press);
    return fmt::format("sides that lean towards each other leave {} between them and {}",
                       millimetres(part.thinnest_m), demand.press);
  }
  if (part.sharpest_ridge_rad < opposite_turn_rad) return {};
  return fmt::format("an edge is as sharp as {:.0f} degrees and {}", 180 - degrees * part.sharpest_ridge_rad,
                     demand.press);
}

/// Why the finger touches more than the nearest surface; empty where the nearest is enough.
std::string second_wall(const ContactDemand& demand) {
  const double radius_m = demand.finger_radius_m, tolerance = demand.force_tolerance;
  if (!(radius_m > 0)) return {};
  if (std::sin(demand.part.sharpest_valley_rad / 2) > tolerance)
    return fmt::format("a {} finger touches two walls at once where they meet at {:.0f} degrees",
                       millimetres(radius_m), 180 - degrees * demand.part.sharpest_valley_rad);
  if (demand.part.tightest_hollow_m < radius_m && std::sin(right_angle_rad / 2) > tolerance)
    return fmt::format("a {} finger bridges hollows of {} radius", millimetres(radius_m),
                       millimetres(demand.part.tightest_hollow_m));
  return {};
}

/// Why a pressed finger would be let go over an edge or a rounding before it is past it.
std::string side_nearer(const ContactDemand& demand) {
  const PartMeasures& part = demand.part;
  if (demand.centre_depth_m <= 0) return {};
  if (2 * std::sin(part.sharpest_edge_rad / 2) > demand.force_tolerance)
    return fmt::format("near an edge of {:.0f} degrees the face beside it is the nearer one, and {}",
                       180 - degrees * part.sharpest_edge_rad, demand.press);
  if (part.tightest_round_m < round_known_to * demand.centre_depth_m)
    return fmt::format("it is rounded by as little as {}, and {}", millimetres(part.tightest_round_m),
                       demand.press);
  return {};
}

}  // namespace

std::string closest_point_fails(const ContactDemand& demand) {
  std::string why = unknown_inside(demand.part);
  if (why.empty()) why = way_through(demand);
  if (why.empty()) why = second_wall(demand);
  if (why.empty() && demand.has_neighbour)
    why = "another surface is so near that the finger can touch both at once";
  if (why.empty()) why = side_nearer(demand);
  return why;
}

std::string closest_point_holds(const ContactDemand& demand) {
  if (demand.centre_depth_m <= 0)
    return demand.press + " and no more: its centre stays outside, and it touches one wall at a time";
  if (!std::isfinite(demand.part.thinnest_m))
    return "it is closed and has no walls that face away from each other";
  const bool has_walls = std::isfinite(demand.part.thinnest_wall_m);
  return fmt::format(
      "{} {} mm {} or more and {}", has_walls ? "walls are" : "sides that lean leave",
      rounded_text(1e3 * (has_walls ? demand.part.thinnest_wall_m : demand.part.thinnest_m), 3),
      has_walls ? "thick" : "between them", demand.press);
}

}  // namespace fingerpad
