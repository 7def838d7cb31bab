#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/contact_method_table.hpp"
#include "contact/part_measures.hpp"
#include "contact/proxy.hpp"

namespace fingerpad {

/// The closest-point method with searches that look at no more than so many triangles in a tick.
std::unique_ptr<ContactMethod> brief_closest_point(std::vector<PlacedSurface> surfaces, double radius_m,
                                                   Normals normals, long most_looks);

namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double right_angle_rad = std::numbers::pi / 2;

/// A proxy that stays on the surfaces: what it stands on holds the finger.
class ProxyMethod final : public ContactMethod {
 public:
  ProxyMethod(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals)
      : proxy_(fast_proxy(surfaces, radius_m, normals)),
        until_placed_(brief_closest_point(std::move(surfaces), radius_m, normals, ProxyLimits::most_looks)) {}

  const Contact& touch(const Vec3& p_WQ, double dt_s) noexcept override {
    const ProxyContact& proxy = proxy_.move(p_WQ, dt_s);
    if (!proxy.placed) contact_ = until_placed_->touch(p_WQ, dt_s);
    contact_.started = proxy.started;
    contact_.placed = proxy.placed;
    contact_.broken_off = proxy.broken_off;
    if (!proxy.placed) return contact_;
    contact_.hold_count = proxy.touching ? proxy.hold_count : 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(contact_.hold_count); ++k) {
      const ProxyHold& hold = proxy.holds[k];
      contact_.holds[k] = {hold.surface, hold.triangle, hold.point_W, hold.normal_W, hold.share_m};
    }
    contact_.depth_m = proxy.depth_m;
    contact_.point_W = proxy.point_W;
    contact_.normal_W = proxy.normal_W;
    return contact_;
  }

  void reset() noexcept override {
    proxy_.reset();
    until_placed_->reset();
  }

 private:
  Proxy proxy_;
  std::unique_ptr<ContactMethod> until_placed_;  ///< serves where no place for the ball has been found yet
  Contact contact_;
};

std::string millimetres(double length_m) {
  return fmt::format("{:.3g} mm", 1e3 * length_m);
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

/// Closest-point answers from the nearest surface, so it is wrong where that changes under the finger:
///   - the part is open, wound against itself or inside out: its inside is not known;
///   - bodies of the part overlap or touch over an area, or it passes through itself: the nearest sheet may
///     be one that lies inside of another body, and its side says nothing (seen by samples: PartMeasures);
///   - a wall is thinner than twice the depth to which the finger's centre is pressed: beyond its middle the
///     far side is nearer;
///   - a knife edge, whose material is sharper than 60 degrees, where the centre can get inside;
///   - the finger has a radius and touches two walls at once: in a concave crease that turns by phi, where
///     the nearest wall alone is wrong by sin(phi/2) of the force, or in a hollow of a smaller radius (taken
///     as a right angle), where that is more than the force tolerance;
///   - another surface stands nearer than the finger's width.
/// A blunter convex edge does not: there closest-point lets the finger slip off sideways when it is as near
/// to the other face as it is deep, but never pushes it on through.
std::string needed(const ContactDemand& demand) {
  std::string why = unknown_inside(demand.part);
  if (why.empty()) why = way_through(demand);
  if (why.empty()) why = second_wall(demand);
  if (why.empty() && demand.has_neighbour)
    why = "another surface is so near that the finger can touch both at once";
  return why;
}

}  // namespace

ContactMethodEntry proxy_method() noexcept {
  return {"proxy",
          "a ball that follows the finger and stays outside (god-object; Zilles & Salisbury 1995)",
          "holds thin walls, knife edges, corners, open and badly wound meshes, several surfaces at once",
          true,
          true,
          false,
          needed,
          [](std::vector<PlacedSurface> surfaces, double radius_m,
             Normals normals) -> std::unique_ptr<ContactMethod> {
            return std::make_unique<ProxyMethod>(std::move(surfaces), radius_m, normals);
          }};
}

}  // namespace fingerpad
