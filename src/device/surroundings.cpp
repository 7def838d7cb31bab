#include "device/surroundings.hpp"

#include <algorithm>
#include <cmath>

#include "contact/contact_method_table.hpp"
#include "scene/scene.hpp"
#include "touch/parts_ball.hpp"

namespace fingerpad {

Surroundings::Surroundings(std::shared_ptr<const World> world, const Scene& scene)
    : kept_(std::move(world)),
      world_(kept_.get()),
      normals_(Normals::facet),
      finger_radius_m_(scene.finger.radius_m),
      memories_(world_->surfaces.size()) {
  touch_by(settled_contact(scene, *world_));
  const auto parts = ball_of_parts(*world_);
  if (!parts) return;
  middle_W_ = parts->centre_W;
  radius_m_ = std::max(parts->radius_m, 1e-6);
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
  Clearance clearance{reach_m, Vec3::Zero()};
  for (std::size_t i = 0; i < world_->surfaces.size(); ++i) {
    const Surface& surface = world_->surfaces[i];
    if (surface.part && !surface.tree) continue;
    const WorldPoint near = nearest_point(surface, p_W, normals_, memories_[i], finger_radius_m_ + reach_m);
    if (!near.found) continue;
    const bool sided = sided_ || surface.is_plane();
    const double distance_m = sided ? near.signed_distance_m : std::abs(near.signed_distance_m);
    const double free_m = distance_m - finger_radius_m_;
    if (!(free_m < clearance.free_m)) continue;
    clearance.free_m = free_m;
    const Vec3 way_W = p_W - near.point_W;
    const double length_m = way_W.norm();
    // A finger that was let go stands on the surface, to within a proxy's skin on either side of it.
    const bool tells = !sided && length_m > 1e-6 * radius_m_;
    clearance.away_W = tells ? Vec3(way_W / length_m) : near.normal_W;
  }
  return clearance;
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
