#include "contact/fast_proxy.hpp"

#include <algorithm>
#include <utility>

#include "contact/proxy_memory.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {

Proxy fast_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals) {
  const bool is_huge = std::ranges::any_of(
      surfaces, [](const PlacedSurface& surface) { return surface.tree && surface.tree->is_huge(); });
  const Looks looks(is_huge ? ServoLooks::most_huge : ServoLooks::most);
  return fast_proxy(std::move(surfaces), radius_m, normals, looks);
}

Proxy fast_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals, Looks looks) {
  return Proxy(std::make_unique<ProxyMemory>(ProxyWorld(std::move(surfaces), radius_m, normals), looks));
}

}  // namespace fingerpad
