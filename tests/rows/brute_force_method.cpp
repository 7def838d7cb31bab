#include <cmath>

#include "contact/contact_method_table.hpp"
#include "contact/placed_surface.hpp"
#include "contact/surface_point.hpp"
#include "support/brute_force.hpp"

namespace fingerpad {
namespace {

/// Looks at every triangle of every part, with facet normals alone.
class BruteForce final : public ContactMethod {
 public:
  BruteForce(std::vector<PlacedSurface> surfaces, double radius_m)
      : surfaces_(std::move(surfaces)), radius_m_(radius_m) {}

  const Contact& touch(const Vec3& p_WQ, double /*dt_s*/) noexcept override {
    contact_ = {};
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      ContactHold hold = surfaces_[i].is_plane() ? on_plane(surfaces_[i], p_WQ) : on_part(surfaces_[i], p_WQ);
      hold.surface = static_cast<int>(i);
      if (hold.share_m > contact_.depth_m) contact_ = {1, {hold}, hold.share_m, hold.point_W, hold.normal_W};
    }
    return contact_;
  }
  void reset() noexcept override {}

 private:
  ContactHold on_plane(const PlacedSurface& plane, const Vec3& p_WQ) const noexcept {
    const double height_m = plane.plane_normal_W.dot(p_WQ - plane.plane_point_W);
    return {-1, -1, p_WQ - height_m * plane.plane_normal_W, plane.plane_normal_W, radius_m_ - height_m};
  }
  ContactHold on_part(const PlacedSurface& placed, const Vec3& p_WQ) const noexcept {
    const Part& part = *placed.part;
    const Vec3 q = placed.R_WP.transpose() * (p_WQ - placed.p_WP) - part.centre_P;
    const test::BruteClosest closest = test::brute_closest(part, q);
    const double side = test::winding_number(part, q) > 0.5 ? -1 : 1;
    const Vec3 normal_P = side * (q - closest.point) / closest.distance_m;
    return {-1, closest.triangle, placed.R_WP * (part.centre_P + closest.point) + placed.p_WP,
            placed.R_WP * normal_P, radius_m_ - side * closest.distance_m};
  }

  std::vector<PlacedSurface> surfaces_;
  double radius_m_;
  Contact contact_;
};

}  // namespace

ContactMethodEntry brute_force_method() noexcept {
  return {.name = "brute-force",
          .summary = "looks at every triangle",
          .holds = "what closest-point holds, slowly",
          .make = [](std::vector<PlacedSurface> surfaces, double radius_m,
                     Normals) -> std::unique_ptr<ContactMethod> {
            return std::make_unique<BruteForce>(std::move(surfaces), radius_m);
          }};
}

}  // namespace fingerpad
