#include "contact/fast_proxy.hpp"

#include <utility>

#include "contact/proxy_memory.hpp"

namespace fingerpad {

Proxy fast_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals) {
  return fast_proxy(std::move(surfaces), radius_m, normals, Looks(ServoLooks::most));
}

Proxy fast_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals, Looks looks) {
  return Proxy(std::make_unique<ProxyMemory>(ProxyWorld(std::move(surfaces), radius_m, normals), looks));
}

}  // namespace fingerpad
