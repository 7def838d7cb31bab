#include "contact/fast_proxy.hpp"

#include <algorithm>
#include <utility>

#include "contact/proxy_memory.hpp"

namespace fingerpad {

long ServoLooks::most_among(std::span<const PlacedSurface> surfaces) noexcept {
  int largest = 0;
  for (const PlacedSurface& surface : surfaces) {
    if (surface.tree) largest = std::max(largest, surface.tree->part().triangle_count());
  }
  return largest <= cached_triangles ? most : most_from_memory;
}

Proxy fast_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals) {
  const Looks looks(ServoLooks::most_among(surfaces));
  return fast_proxy(std::move(surfaces), radius_m, normals, looks);
}

Proxy fast_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals, Looks looks) {
  return Proxy(std::make_unique<ProxyMemory>(ProxyWorld(std::move(surfaces), radius_m, normals), looks));
}

}  // namespace fingerpad
