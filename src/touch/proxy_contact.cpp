#include "touch/proxy_contact.hpp"

namespace fingerpad {

Proxy world_proxy(const World& world, double radius_m, Normals normals) {
  std::vector<ProxySurface> surfaces;
  for (const Surface& surface : world.surfaces) {
    surfaces.push_back(
        {surface.tree, surface.p_WP, surface.R_WP, surface.plane_point_W, surface.plane_normal_W});
  }
  return {std::move(surfaces), radius_m, normals};
}

bool started_inside(const ProxyContact& contact, const World& world, const Vec3& p_WQ) noexcept {
  if (!contact.started || (contact.placed && !contact.touching)) return false;
  if (!contact.placed) return true;
  const Surface& surface = world.surfaces[static_cast<std::size_t>(contact.holds[0].surface)];
  return surface.part && (p_WQ - contact.point_W).dot(contact.direction_W) < 0;
}

}  // namespace fingerpad
