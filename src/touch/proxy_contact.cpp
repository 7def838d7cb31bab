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

bool is_inside_part(const TickRecord& record, const World& world) noexcept {
  if (record.phase == Phase::free || record.surface < 0) return false;
  return world.surfaces[static_cast<std::size_t>(record.surface)].part &&
         (record.p_WQ - record.contact_W).dot(record.normal_W) < 0;
}

}  // namespace fingerpad
