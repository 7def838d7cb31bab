#pragma once

#include <vector>

#include "contact/proxies.hpp"
#include "contact/proxy_views.hpp"
#include "support/shapes.hpp"

// Proxies whose ticks may look at little, and what they are tried on.

namespace fingerpad::test {

/// What a tick may look at beyond its looks: it ends with the search that spends them, and with the fans
/// about a facet's corners.
inline constexpr long most_beyond =
    LookCosts::fetched * (ProxyMemoryLimits::richest_view + 6 * ProxyLimits::most_turns) +
    ProxyMemoryLimits::search_looks;

inline Proxy limited_proxy(bool fast, const PlacedSurface& surface, double radius_m, Normals normals,
                           long looks) {
  return fast ? fast_proxy({surface}, radius_m, normals, Looks(looks))
              : Proxy(std::make_unique<LimitedSight>(ProxyWorld({surface}, radius_m, normals), Looks(looks)));
}

struct LooksTrial {
  const char* name;
  TriangleSoup soup;
  double radius_m;
};

inline std::vector<LooksTrial> looks_trials() {
  const TriangleSoup crossing =
      joined(box_soup(Vec3(0.04, 0.03, 0.02)), moved(torus_soup(0.02, 0.006, 24, 12), Vec3(0, 0, 0.012)));
  return {{"a point about a box and a ring", crossing, 0},
          {"a ball about a box and a ring", crossing, 0.002},
          {"a ball on a sphere", sphere_soup(0.02, 3), 0.003},
          {"a point at a thin plate", box_soup(Vec3(0.05, 0.05, 0.0002)), 0},
          {"a ball in a valley", roof_soup(0.05, -1.2), 0.004}};
}

}  // namespace fingerpad::test
