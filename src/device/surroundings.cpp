#include "device/surroundings.hpp"

#include <algorithm>

#include "contact/contact_method_table.hpp"
#include "scene/scene.hpp"
#include "touch/nearest_of.hpp"

namespace fingerpad {

Ball ball_around(const World& world) {
  constexpr double usual_m = 0.05, least_m = 1e-6;
  const auto parts = ball_of_parts(world);
  return parts ? Ball{parts->centre_W, std::max(parts->radius_m, least_m)} : Ball{Vec3::Zero(), usual_m};
}

Surroundings::Surroundings(std::shared_ptr<const World> world, const Scene& scene)
    : Surroundings(std::move(world), scene, scene.finger.radius_m) {}

Surroundings::Surroundings(std::shared_ptr<const World> world, const Scene& scene, double finger_radius_m)
    : kept_(std::move(world)),
      world_(kept_.get()),
      normals_(Normals::facet),
      finger_radius_m_(finger_radius_m),
      memories_(world_->surfaces.size()),
      parts_(ball_around(*world_)) {
  touch_by(settled_contact(scene, *world_));
}

void Surroundings::touch_by(const ContactChoice& choice) noexcept {
  const ContactMethodEntry* const method = find_contact_method(choice.method);
  sided_ = method != nullptr && !method->starts_outside;
  normals_ = method != nullptr && method->touches_own_surface ? choice.normals : Normals::facet;
}

void Surroundings::change(const World& world, const ContactChoice& choice) noexcept {
  world_ = &world;
  touch_by(choice);
}

Clearance Surroundings::at(const Vec3& p_W, double reach_m) noexcept {
  const double far_m = finger_radius_m_ + reach_m;
  const auto find = [&](std::size_t i) {
    return nearest_point(world_->surfaces[i], p_W, normals_, memories_[i], far_m);
  };
  const NearestSurface nearest = nearest_of(*world_, far_m, find, [&](std::size_t) { return sided_; });
  const double free_m = nearest.clear_m - finger_radius_m_;
  if (nearest.surface < 0 || !(free_m < reach_m)) return {reach_m, Vec3::Zero()};
  const Vec3 way_W = p_W - nearest.at.point_W;
  const double length_m = way_W.norm();
  const bool is_sided = sided_ || world_->surfaces[static_cast<std::size_t>(nearest.surface)].is_plane();
  // A finger that was let go stands on the surface, to within a proxy's skin on either side of it.
  const bool tells = !is_sided && length_m > 1e-6 * parts_.radius_m;
  return {free_m, tells ? Vec3(way_W / length_m) : nearest.at.normal_W};
}

double Surroundings::stiffest_n_per_m(double dt_s) const noexcept {
  double most = 0;
  for (const Surface& surface : world_->surfaces) {
    const SurfaceProperties& properties = surface.properties;
    most = std::max(most, properties.stiffness_n_per_m + properties.damping_n_s_per_m / dt_s);
  }
  return most > 0 ? most : 1;
}

}  // namespace fingerpad
